#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/body/BodyDefinition.hpp"

namespace thinwall {

/// Along which axes `fixed` holds each vertex, (vertices).
std::vector<std::array<bool, 3>> held_axes(const SurfaceMesh& mesh, std::span<const FixedRegion> fixed);

}  // namespace thinwall
