#pragma once

#include <vector>

#include "engine/cutting/CutPatch.hpp"
#include "engine/cutting/WantedPath.hpp"

namespace thinwall {

/// Refines the triangles along a path until their edges are about `edge_length` metres long (at most 1.6 times that):
/// each into four of its own shape, nested, so that nothing is lost; neighbours are divided in two or three where that
/// keeps the angles allowed, otherwise refined too. Triangles stay as they are where their neighbours are frozen, or
/// fine already, and cannot be divided: returns false when there are such along the path. Stops at edges that were
/// split move to the halves.
bool refine_along(CutPatch& patch, std::vector<PathStop>& stops, double edge_length);

}  // namespace thinwall
