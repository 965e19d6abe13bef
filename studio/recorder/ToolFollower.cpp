#include "studio/recorder/ToolFollower.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace thinwall {

ToolFollower::ToolFollower(std::string tool, double smoothing) : tool_(std::move(tool)), constant_(0.5 * smoothing) {}

void ToolFollower::add(const Snapshot& snapshot) {
  const Double3& tip = tip_in(snapshot);
  earlier_ = has_begun_ ? later_ : State{snapshot.time, tip, tip, tip};
  later_ = advanced(earlier_, snapshot.time, tip);
  has_begun_ = true;
}

Double3 ToolFollower::at(const Snapshot& snapshot) const {
  return advanced(earlier_, snapshot.time, tip_in(snapshot)).twice;
}

/// With x = tip + v s the equations constant * y' = x - y, constant * z' = y - z have the solutions
/// y = x - v T + C e, z = x - 2 v T + (C s / T + D) e with e = exp(-s / T), T the constant.
ToolFollower::State ToolFollower::advanced(const State& from, double time, const Double3& tip) const {
  const double span = time - from.time;
  if (constant_ <= 0) return {time, tip, tip, tip};
  if (span <= 0) return from;
  const double decay = std::exp(-span / constant_);
  State next{.time = time, .tip = tip};
  for (std::size_t i = 0; i < 3; ++i) {
    const double lag = (tip[i] - from.tip[i]) / span * constant_;
    const double first = from.once[i] - from.tip[i] + lag;
    const double second = from.twice[i] - from.tip[i] + 2 * lag;
    next.once[i] = tip[i] - lag + first * decay;
    next.twice[i] = tip[i] - 2 * lag + (first * span / constant_ + second) * decay;
  }
  return next;
}

const Double3& ToolFollower::tip_in(const Snapshot& snapshot) const {
  const auto tool = std::ranges::find(snapshot.tools, tool_, &SnapshotTool::name);
  if (tool == snapshot.tools.end()) {
    throw std::invalid_argument("a camera follows tool '" + tool_ + "', which the take does not have");
  }
  return tool->tip;
}

}  // namespace thinwall
