#pragma once

#include <span>
#include <vector>

#include "engine/cutting/Cut.hpp"
#include "engine/mesh/SurfaceMesh.hpp"

namespace thinwall {

/// Where points of a wall are after a cut, in their order: the same places of the rest shape, to round-off. A point on
/// the cut itself goes to one of its lips. Points that followed each other in one closed triangle do so in one flat
/// piece, as a CutPath may have them, unless the cut now lies between them (path_through tells): so what lies ahead of
/// the blade can be carried over and cut later.
/// `before`, `after`: the wall's mesh around the cut.
std::vector<SurfacePoint> carried_over(std::span<const SurfacePoint> points, const SurfaceMesh& before,
                                       const SurfaceMesh& after, const Cut& cut);

}  // namespace thinwall
