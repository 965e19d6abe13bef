#pragma once

#include <vector>

#include "engine/cutting/CutSurface.hpp"

namespace thinwall {

/// Numbers on the surface of what a patch consists of.
struct CutSurface::PatchNumbers {
  std::vector<int> triangles, vertices, facets;
  std::vector<int> local_triangle;  // (triangles of the surface), of the patch; -1: outside
};

}  // namespace thinwall
