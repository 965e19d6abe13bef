#pragma once

#include <span>

#include "renderer/shape/SurfaceVertices.hpp"

namespace thinwall {

struct CreaseDefinition {
  double reach = 0;      // metres, from the other wall, up to which a wall is shaded
  double curvature = 0;  // 1 / metre, of a dent that is as dark as where both walls meet
};

/// Shades the creases in which walls of different bodies meet, as where an organ lies in another: half of the room that
/// light comes from is hidden there. Vertices near another wall count as lying in a dent, the nearer to its tangent
/// planes the deeper. `walls`: outer walls of the bodies.
void shade_creases(std::span<const std::span<SurfaceVertex>> walls, const CreaseDefinition& crease);

}  // namespace thinwall
