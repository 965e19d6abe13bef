#include "studio/recorder/SetAsideTools.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "renderer/snapshot/SameTime.hpp"

namespace thinwall {
namespace {

constexpr std::string_view kIdle = "idle", kWithdrawal = "withdrawal", kHold = "hold";

/// Whether a tool in this phase waits, or is done, as far as its own clip goes.
bool is_at_rest(std::string_view phase) {
  return phase == kIdle || phase == kWithdrawal || phase == kHold;
}

}  // namespace

void SetAsideTools::add(const Snapshot& snapshot) {
  const std::size_t count = snapshot.tools.size();
  phases_.resize(count, std::string(kIdle));
  later_.resize(count);
  earlier_ = later_;
  time_ = snapshot.time;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& phase = snapshot.tools[i].phase;
    if (is_at_rest(phase) || !is_at_rest(phases_[i])) continue;
    later_[i].begun = snapshot.time;
    for (std::size_t other = 0; other < count; ++other) {
      if (other != i) later_[other].is_outdone = true;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& phase = snapshot.tools[i].phase;
    State& state = later_[i];
    state.is_idle = phase == kIdle;
    if (phase == kWithdrawal) state.is_placed = false;
    if (!is_at_rest(phase)) {
      state.is_placed = true;
      state.is_outdone = false;
    }
    phases_[i] = phase;
  }
}

const std::vector<SetAsideTools::State>& SetAsideTools::states(double time) const {
  return time > time_ - kSameTime ? later_ : earlier_;
}

double SetAsideTools::begun(std::size_t tool, double time) const {
  const std::vector<State>& as_of_then = states(time);
  return tool < as_of_then.size() ? as_of_then[tool].begun : -1;
}

void SetAsideTools::mark(Snapshot& snapshot) const {
  const std::vector<State>& states = this->states(snapshot.time);
  for (std::size_t i = 0; i < std::min(states.size(), snapshot.tools.size()); ++i) {
    const State& state = states[i];
    snapshot.tools[i].is_set_aside = state.is_idle && state.is_outdone && !state.is_placed;
  }
}

}  // namespace thinwall
