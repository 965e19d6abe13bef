#include "studio/director/GraspPlan.hpp"

#include <algorithm>
#include <cmath>

#include "engine/cutting/BorderCrossing.hpp"

namespace thinwall {
namespace {

/// Part of their grip by which jaws may squeeze with more or less: what is found within a few steps.
constexpr double kGripTolerance = 0.01;

/// Part of the way between two openings that is kept from either: squeezes grow ever faster, and where the straight
/// line between them is taken alone the looser one would hardly move.
constexpr double kInnerPart = 0.1;

/// Metres between openings, of which no wall feels the difference.
constexpr double kSameOpening = 1e-8;

}  // namespace

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
  if (clip.grip > 0 && !has_settled) settle({.opening = opening, .force = squeeze});
}

void GraspPlan::settle(const JawSqueeze& now) {
  (now.force < clip.grip ? looser : firmer) = now;
  if (!firmer) return;
  const bool is_as_wanted = std::abs(now.force - clip.grip) <= kGripTolerance * clip.grip;
  has_settled = is_as_wanted || !looser || looser->opening - firmer->opening < kSameOpening;
  stopped = now.opening;
  if (has_settled) return;
  // A step closes the jaws by much of what a wall can be squeezed by: it ends beyond the grip, and they open a little.
  const double part = (clip.grip - looser->force) / (firmer->force - looser->force);
  stopped = std::lerp(looser->opening, firmer->opening, std::clamp(part, kInnerPart, 1 - kInnerPart));
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
