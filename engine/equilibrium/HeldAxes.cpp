#include "engine/equilibrium/HeldAxes.hpp"

namespace thinwall {

std::vector<std::array<bool, 3>> held_axes(const SurfaceMesh& mesh, std::span<const FixedRegion> fixed) {
  std::vector<std::array<bool, 3>> held(mesh.vertices.size(), {false, false, false});
  for (const FixedRegion& region : fixed) {
    for (const int vertex : vertices_in(region.region, mesh)) {
      for (int axis = 0; axis < 3; ++axis) held[vertex][axis] = held[vertex][axis] || region.axes[axis];
    }
  }
  return held;
}

}  // namespace thinwall
