#include "tests/engine/contact/SurfaceIntersections.hpp"

#include <Eigen/Geometry>

#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
std::vector<SurfaceIntersection> surface_intersections(std::span<const Eigen::Vector3i> triangles,
                                                       const Eigen::VectorXd& position) {
  const auto at = [&](int vertex) -> Eigen::Vector3d { return position.segment<3>(3 * vertex); };
  const MeshTopology topology = topology_of(static_cast<int>(position.size() / 3), triangles);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Eigen::Vector3i& triangle : triangles) {
    Eigen::AlignedBox3d& box = boxes.emplace_back();
    for (const int vertex : triangle) box.extend(at(vertex));
  }
  std::vector<SurfaceIntersection> found;
  for (const auto& edge : topology.edges) {
    Eigen::AlignedBox3d box(at(edge[0]));
    box.extend(at(edge[1]));
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (!box.intersects(boxes[t])) continue;
      const Eigen::Vector3i& corners = triangles[t];
      if ((corners.array() == edge[0] || corners.array() == edge[1]).any()) continue;
      if (passes_through({at(edge[0]), at(edge[1])}, {at(corners[0]), at(corners[1]), at(corners[2])})) {
        found.push_back({.edge = edge, .triangle = static_cast<int>(t)});
      }
    }
  }
  return found;
}

}  // namespace thinwall
