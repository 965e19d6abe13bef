#include "studio/director/KeptWay.hpp"

#include <algorithm>
#include <limits>

#include "studio/director/BodyExtent.hpp"

namespace thinwall {
namespace {

/// Where there is no stand-off the way back to a free place is first sought this far behind, metres.
constexpr double kLeastBack = 1e-6;

/// How often it may be doubled: to beyond any body.
constexpr int kMostDoublings = 40;

/// A place from which a tool can go ahead.
struct FreePlace {
  double back = 0;    // metres that it lies behind where it was looked for
  double travel = 0;  // metres from it to first contact, infinite where nothing is met
};

/// The first place, on the way back from a pose, where a tool is outside and touches nothing: there, or `standoff`
/// behind it, or twice, four times, ... as far.
FreePlace free_place(const ToolPose& pose, const ToolDefinition& tool, const SurfaceView& surface, double standoff) {
  FreePlace place;
  for (int k = 0; k < kMostDoublings; ++k) {
    ToolPose behind = pose;
    behind.tip -= place.back * pose.direction;
    const auto travel = travel_to_contact(surface, tool, behind, pose.direction);
    place.travel = travel.value_or(std::numeric_limits<double>::infinity());
    if (place.travel > 0 && !is_inside(surface, behind.tip)) break;
    place.back = std::max({2 * place.back, standoff, kLeastBack});
  }
  return place;
}

void keep(PalpationPlan& plan, const ToolDefinition& tool, const SurfaceView& now) {
  const FreePlace place = free_place(plan.begin, tool, now, plan.clip.standoff);
  const double to_old_wall = place.back + plan.to_contact;
  plan.begin.tip -= place.back * plan.begin.direction;
  const bool meets_wall = first_entry(now, plan.begin.tip, plan.begin.direction).has_value();
  plan.to_contact = meets_wall ? place.travel : std::min(place.travel, to_old_wall);
}

void keep(IncisionPlan& plan, const ToolDefinition& tool, const SurfaceView& now) {
  const FreePlace place = free_place(plan.begin, tool, now, plan.clip.standoff);
  plan.begin.tip -= place.back * plan.begin.direction;
  plan.clip.standoff += place.back;
  plan.to_contact = std::min(place.travel, plan.clip.standoff);
  plan.clip.marked = false;  // there is no wall to draw on
  // What the blade has to put into the dent before it goes in is told by the triangle where it begins.
  const auto nearest = project(now, plan.path.stations.front().position, {}, std::numeric_limits<double>::infinity());
  plan.path.pieces.front().points.front() = *nearest.point;
}

}  // namespace

std::optional<Plan> kept_way(const Plan& first, const ToolDefinition& tool, const SurfaceView& now) {
  Plan plan = first;
  if (auto* palpation = std::get_if<PalpationPlan>(&plan)) {
    keep(*palpation, tool, now);
  } else if (auto* piercing = std::get_if<PiercingPlan>(&plan)) {
    keep(*piercing, tool, now);
  } else if (auto* incision = std::get_if<IncisionPlan>(&plan)) {
    keep(*incision, tool, now);
  } else if (!std::holds_alternative<GraspPlan>(plan)) {
    return std::nullopt;
  }
  return plan;
}

}  // namespace thinwall
