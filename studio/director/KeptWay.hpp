#pragma once

#include <optional>

#include "studio/director/Plan.hpp"

namespace thinwall {

/// The way that a tool had when the run began, for a clip that finds none on the wall as it is now: one that aims into
/// a gaping cut, or at a wall that has been emptied or drawn away. `now`: the surface of the clip's body. The tool goes
/// where it would have gone; where it would touch the wall at its stand-off it begins farther back. Depth counts from
/// first contact; where the line of approach meets no wall any more, at the latest from where it was. Nothing for a
/// plan that brings no tool to a wall.
std::optional<Plan> kept_way(const Plan& first, const ToolDefinition& tool, const SurfaceView& now);

}  // namespace thinwall
