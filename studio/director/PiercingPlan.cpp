#include "studio/director/PiercingPlan.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "renderer/snapshot/SameTime.hpp"
#include "studio/director/BodyExtent.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {
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
  if (clip.depth > tool.length) {
    refuse(
        fmt::format("`depth` = {:.4g} mm is more than needle `{}` is long ({:.4g} mm); go less deep or give it a "
                    "larger `length`",
                    1e3 * clip.depth, clip.tool, 1e3 * tool.length));
  }
  return plan;
}

}  // namespace thinwall
