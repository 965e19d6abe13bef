#include "studio/director/GraspPlan.hpp"

#include <algorithm>

#include "engine/cutting/BorderCrossing.hpp"

namespace thinwall {

double GraspPlan::duration() const {
  return (clip.standoff + clip.depth) / clip.speed + clip.duration;
}

ToolMoment GraspPlan::at(double time) const {
  const double in = clip.standoff + clip.depth;  // metres
  const double arrival = in / clip.speed;        // seconds
  ToolMoment moment{.pose = begin, .phase = "approach"};
  moment.pose.tip += std::min(in, std::max(0.0, time) * clip.speed) * begin.direction;
  if (time <= arrival) return moment;
  // The tip stands still while the jaws close.
  moment.phase = "hold";
  const double part = std::clamp((time - arrival) / clip.duration, 0.0, 1.0);
  moment.pose.opening = begin.opening + part * (clip.to - begin.opening);
  if (stopped) moment.pose.opening = std::max(moment.pose.opening, *stopped);
  return moment;
}

void GraspPlan::feel(double squeeze, double opening, double time) {
  largest_squeeze = std::max(largest_squeeze, squeeze);
  if (squeeze > 0) {
    lost.reset();
  } else if (largest_squeeze > 0 && !lost) {
    lost = time;
  }
  if (clip.grip > 0 && !stopped && squeeze >= clip.grip) stopped = opening;
}

GraspPlan plan_grasp(const GraspClip& clip, const ToolDefinition& tool, const SurfaceView& surface,
                     std::span<const double> thickness, const SourceLocation& location) {
  const Eigen::Vector3d direction = clip.direction.normalized().array() + 0.0;
  const std::optional<SurfaceEntry> rim = first_rim(surface, thickness, clip.at, direction);
  const std::optional<SurfaceEntry> entry = first_entry(surface, clip.at, direction);
  const bool is_at_rim = rim && !(entry && entry->travel <= rim->travel);
  const SurfaceEntry hit =
      is_at_rim ? *rim : meet_on_approach({"grasp", clip.at, direction, clip.body}, surface, location);
  GraspPlan plan{.clip = clip,
                 .begin = make_pose(clip.at + (hit.travel - clip.standoff) * direction, direction, clip.axis),
                 .stopped = {},
                 .lost = {},
                 .jaw_width = tool.width};
  plan.begin.opening = tool.opening;
  // Jaws reach over the wall, and need not touch it at all on their way.
  const std::optional<double> travel = travel_to_contact(surface, tool, plan.begin, direction);
  if (travel) refuse_touching(*travel, clip.standoff, {"grasp", clip.tool, clip.body}, location);
  return plan;
}

ToolMoment ReleasePlan::at(double time) const {
  ToolMoment moment{.pose = begin, .phase = "withdrawal"};
  const double part = std::clamp(time / clip.duration, 0.0, 1.0);
  moment.pose.opening = begin.opening + part * (opening - begin.opening);
  return moment;
}

ReleasePlan plan_release(const ReleaseClip& clip, const ToolDefinition& tool, const ToolPose& now) {
  return {.clip = clip, .begin = now, .opening = tool.opening};
}

}  // namespace thinwall
