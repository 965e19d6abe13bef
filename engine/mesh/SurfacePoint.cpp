#include "engine/mesh/SurfacePoint.hpp"

#include <cassert>

namespace thinwall {

SurfacePoint point_at(std::span<const Eigen::Vector3i> triangles, int vertex) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (triangles[t][k] == vertex) return {.triangle = static_cast<int>(t), .weights = Eigen::Vector3d::Unit(k)};
    }
  }
  assert(false && "the vertex belongs to no triangle");
  return {};
}

}  // namespace thinwall
