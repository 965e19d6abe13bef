#include "engine/haptics/Trajectory.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <utility>

namespace thinwall {
namespace {

Eigen::Matrix3d frame_of(const ToolPose& pose) {
  Eigen::Matrix3d frame;
  frame << pose.axis.cross(pose.direction), pose.axis, pose.direction;
  return frame;
}

}  // namespace

ToolPose between(const ToolPose& begin, const ToolPose& end, double part) {
  ToolPose pose = begin;
  pose.tip += part * (end.tip - begin.tip);
  pose.opening += part * (end.opening - begin.opening);
  if (begin.direction == end.direction && begin.axis == end.axis) return pose;
  const Eigen::Quaterniond from(frame_of(begin)), to(frame_of(end));
  const Eigen::Matrix3d frame = from.slerp(part, to).toRotationMatrix();
  pose.axis = frame.col(1);
  pose.direction = frame.col(2);
  return pose;
}

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
