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

void SetAsideTools::State::go_on(const SnapshotTool& tool) {
  is_idle = tool.phase == kIdle;
  // Jaws that let go are in the phase in which other tools go back, but stay where they are.
  lets_go = tool.phase == kWithdrawal && (lets_go || tool.opening > opening);
  is_at_work = lets_go || !is_at_rest(tool.phase);
  opening = tool.opening;
  is_placed = is_at_work || (is_placed && tool.phase != kWithdrawal);
}

void SetAsideTools::add(const Snapshot& snapshot) {
  const std::size_t count = snapshot.tools.size();
  later_.resize(count);
  earlier_ = later_;
  time_ = snapshot.time;
  for (std::size_t i = 0; i < count; ++i) later_[i].go_on(snapshot.tools[i]);
  for (std::size_t i = 0; i < count; ++i) {
    if (!later_[i].is_at_work || earlier_[i].is_at_work) continue;
    later_[i].begun = snapshot.time;
    for (std::size_t other = 0; other < count; ++other) {
      if (other != i) later_[other].is_outdone = true;
    }
  }
  for (State& state : later_) {
    if (state.is_at_work) state.is_outdone = false;
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
