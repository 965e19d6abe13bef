#pragma once

#include <span>
#include <vector>

#include "engine/cutting/Cut.hpp"
#include "engine/cutting/CutPatch.hpp"

namespace thinwall {

/// For each changed triangle of `after` (in order) the triangles of `before` that it overlaps, with shares of its area
/// (clipping of convex polygons in the plane of the facet); sum 1. Both patches have the same facets, and triangles
/// that are not changed are the same in both.
std::vector<TriangleSource> overlaps(const CutPatch& before, const CutPatch& after);

}  // namespace thinwall
