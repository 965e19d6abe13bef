#include "studio/director/PiercingPlan.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/tool/FirstContact.hpp"
#include "renderer/snapshot/SameTime.hpp"
#include "studio/director/BodyExtent.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

/// Radii of a needle in an edge of the wall at most: smaller triangles are made for its slit, and each halving of them
/// makes the steps with it slower.
constexpr double kMostRadii = 2000;

/// Of the triangle that the line of approach meets first, metres; 0 where it meets none.
double longest_edge_ahead(const SurfaceView& surface, const ToolPose& pose) {
  const auto hit = first_entry(surface, pose.tip, pose.direction);
  if (!hit) return 0;
  double longest = 0;
  const Eigen::Vector3i& vertices = surface.triangles[static_cast<std::size_t>(hit->triangle)];
  for (int k = 0; k < 3; ++k) {
    const auto from = surface.position.segment<3>(3 * vertices[k]);
    longest = std::max(longest, (surface.position.segment<3>(3 * vertices[(k + 1) % 3]) - from).norm());
  }
  return longest;
}

}  // namespace

ToolMoment PiercingPlan::at(double time) const {
  ToolMoment moment = PalpationPlan::at(time);
  const auto is_now = [&](double rupture) { return std::abs(rupture - time) <= kSameTime; };
  if (std::ranges::any_of(ruptures, is_now)) {
    moment.phase = "rupture";
  } else if (moment.phase == "contact" && !ruptures.empty() && ruptures.front() < time) {
    moment.phase = "sliding";
  }
  return moment;
}

PiercingPlan plan_piercing(const PierceClip& clip, const ToolDefinition& tool, const SurfaceView& surface,
                           const SourceLocation& location) {
  PiercingPlan plan{plan_palpation(clip, tool, surface, location, "pierce"), {}};
  const auto refuse = [&](const std::string& why) { throw InputErrors({{location, "pierce: " + why}}); };
  const ToolPose& pose = plan.begin;
  const double width =
      std::min(extent_along(surface, pose.axis), extent_along(surface, pose.axis.cross(pose.direction)));
  if (2 * tool.radius >= width) {
    refuse(
        fmt::format("needle `{}` is {:.3g} mm thick, and body `{}` is only {:.3g} mm wide across its way; give it a "
                    "smaller `radius`",
                    clip.tool, 2e3 * tool.radius, clip.body, 1e3 * width));
  }
  const double edge = longest_edge_ahead(surface, plan.begin);
  if (kMostRadii * tool.radius < edge) {
    refuse(fmt::format(
        "needle `{}` is {:.3g} mm thick, and the triangles that it meets have edges of {:.3g} mm, which a slit of its "
        "width cannot be cut into; give it a larger `radius`, or the body more triangles",
        clip.tool, 2e3 * tool.radius, 1e3 * edge));
  }
  if (clip.depth > tool.length) {
    refuse(
        fmt::format("`depth` = {:.4g} mm is more than needle `{}` is long ({:.4g} mm); go less deep or give it a "
                    "larger `length`",
                    1e3 * clip.depth, clip.tool, 1e3 * tool.length));
  }
  return plan;
}

}  // namespace thinwall
