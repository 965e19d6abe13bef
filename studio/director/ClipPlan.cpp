#include "studio/director/ClipPlan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/tool/PoseBetween.hpp"
#include "studio/director/BodyExtent.hpp"
#include "studio/organs/SpanWords.hpp"
#include "studio/scenario/InputError.hpp"
#include "studio/scenario/Parallel.hpp"

namespace thinwall {
namespace {

/// 0 to 1 with the ease of a clip: `smooth` starts and ends at rest (3 t^2 - 2 t^3).
double eased(Ease ease, double part) {
  return ease == Ease::kSmooth ? part * part * (3 - 2 * part) : part;
}

/// The tool as it is, turned as the clip says.
ToolPose attitude_given(const MoveClip& clip, const ToolPose& now, const SourceLocation& location) {
  ToolPose pose = clip.direction ? turned_to(now, clip.direction->normalized()) : now;
  if (!clip.axis) return pose;
  if (are_parallel(*clip.axis, pose.direction)) {
    throw InputErrors({{location, fmt::format("move: the axis lies along the direction that tool `{}` has; give it a "
                                              "`direction` too, or another `axis`",
                                              clip.tool)}});
  }
  pose.axis = make_pose(pose.tip, pose.direction, clip.axis).axis;
  return pose;
}

}  // namespace

ToolPose make_pose(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction,
                   const std::optional<Eigen::Vector3d>& axis) {
  ToolPose pose{.tip = tip, .direction = direction.normalized(), .axis = Eigen::Vector3d::UnitY()};
  const auto across = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
    return v - pose.direction * pose.direction.dot(v);
  };
  Eigen::Vector3d wanted = across(axis.value_or(Eigen::Vector3d::UnitY()));
  if (wanted.norm() < 1e-6) wanted = across(Eigen::Vector3d::UnitX());
  if (wanted.norm() < 1e-6) wanted = across(Eigen::Vector3d::UnitY());
  pose.axis = wanted.normalized();
  return pose;
}

double PalpationPlan::duration() const {
  return (clip.withdraw ? 2 : 1) * arrival() + stay();
}

double PalpationPlan::arrival() const {
  return (to_contact + clip.depth) / clip.speed;
}

double PalpationPlan::stay() const {
  return std::max(clip.hold, rest);
}

ToolMoment PalpationPlan::at(double time) const {
  const double in = to_contact + clip.depth;  // metres
  double travel = std::min(in, std::max(0.0, time) * clip.speed);
  ToolMoment moment;
  moment.phase = travel < to_contact ? "approach" : "contact";
  if (time >= arrival()) moment.phase = "hold";
  const double leaving = arrival() + stay();  // seconds
  if (clip.withdraw && time > leaving) {
    travel = std::max(0.0, in - (time - leaving) * clip.speed);
    moment.phase = "withdrawal";
  }
  moment.pose = begin;
  moment.pose.tip += travel * begin.direction;
  moment.depth = std::max(0.0, travel - to_contact);
  return moment;
}

SurfaceEntry meet_on_approach(const LineOfApproach& line, const SurfaceView& surface, const SourceLocation& location) {
  const Eigen::Vector3d &at = line.at, &direction = line.direction;
  const auto hit = first_entry(surface, at, direction);
  if (hit) return *hit;
  throw InputErrors(
      {{location, fmt::format("{}: the line of approach through at = [{:.4g}, {:.4g}, {:.4g}] mm "
                              "along direction = [{:.3g}, {:.3g}, {:.3g}] misses body `{}`, which spans "
                              "{} then; move `at` or turn `direction` so that the line meets its wall from "
                              "outside",
                              line.verb, 1e3 * at.x(), 1e3 * at.y(), 1e3 * at.z(), direction.x(), direction.y(),
                              direction.z(), line.body, span_words(box_of(surface)))}});
}

void refuse_touching(double travel, double standoff, const ClipWords& words, const SourceLocation& location) {
  if (travel > 0) return;
  throw InputErrors({{location, fmt::format("{}: tool `{}` touches body `{}` already {:.3g} mm from the point of "
                                            "approach; a larger `standoff` than {:.3g} mm lets it start outside",
                                            words.verb, words.tool, words.body, 1e3 * standoff, 1e3 * standoff)}});
}

double free_travel(const ToolPose& pose, const ToolDefinition& tool, const SurfaceView& surface, double standoff,
                   const ClipWords& words, const SourceLocation& location) {
  const auto travel = travel_to_contact(surface, tool, pose, pose.direction);
  if (!travel) {
    throw InputErrors({{location, fmt::format("{}: tool `{}` passes beside body `{}`; move or turn its way so that "
                                              "it meets the wall",
                                              words.verb, words.tool, words.body)}});
  }
  refuse_touching(*travel, standoff, words, location);
  return *travel;
}

PalpationPlan plan_palpation(const PalpateClip& clip, const ToolDefinition& tool, const SurfaceView& surface,
                             const SourceLocation& location, const std::string& verb) {
  // Adding zero turns a negative zero, which would read oddly in a message, into zero.
  const Eigen::Vector3d direction = clip.direction.normalized().array() + 0.0;
  const SurfaceEntry hit = meet_on_approach({verb, clip.at, direction, clip.body}, surface, location);
  PalpationPlan plan{.clip = clip,
                     .begin = make_pose(clip.at + (hit.travel - clip.standoff) * direction, direction, clip.axis)};
  plan.begin.opening = tool.opening;
  plan.to_contact = free_travel(plan.begin, tool, surface, clip.standoff, {verb, clip.tool, clip.body}, location);
  return plan;
}

ToolMoment MovePlan::at(double time) const {
  const double part = eased(clip.ease, std::clamp(time / clip.duration, 0.0, 1.0));
  return {.pose = between(begin, end, part), .phase = "approach"};
}

MovePlan plan_move(const MoveClip& clip, const ToolPose& now, bool is_first, const SourceLocation& location) {
  const Eigen::Vector3d from = clip.from.value_or(now.tip), to = clip.end_from(from);
  MovePlan plan{.clip = clip, .begin = now, .end = now};
  if (is_first) {
    const Eigen::Vector3d way = to - from;
    plan.end = make_pose(to, clip.direction.value_or(way.norm() > 0 ? way : now.direction), clip.axis);
    plan.end.opening = now.opening;
  } else {
    plan.end = attitude_given(clip, now, location);
  }
  if (is_first || (from - now.tip).norm() > kSamePlace) plan.begin = plan.end;
  plan.begin.tip = from;
  plan.end.tip = to;
  return plan;
}

}  // namespace thinwall
