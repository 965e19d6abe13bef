#include "engine/haptics/Trajectory.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/tool/PoseBetween.hpp"

namespace thinwall {

Trajectory::Trajectory(std::vector<TimedPose> moments) : moments_(std::move(moments)) {
  assert(!moments_.empty());
}

std::optional<ToolPose> Trajectory::pose_at(double time) {
  if (time > end()) return std::nullopt;
  const auto after = std::ranges::upper_bound(moments_, time, {}, &TimedPose::time);
  if (after == moments_.begin()) return moments_.front().pose;
  if (after == moments_.end()) return moments_.back().pose;
  const TimedPose& before = *(after - 1);
  return between(before.pose, after->pose, (time - before.time) / (after->time - before.time));
}

}  // namespace thinwall
