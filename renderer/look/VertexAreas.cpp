#include "renderer/look/VertexAreas.hpp"

#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

std::vector<double> vertex_areas(const SnapshotTopology& topology) {
  std::vector<double> areas(topology.rest_positions.size(), 0);
  for (const Triangle& triangle : topology.triangles) {
    const Vector3 corner = vector3(topology.rest_positions[triangle[0]]);
    const Vector3 product = cross(vector3(topology.rest_positions[triangle[1]]) - corner,
                                  vector3(topology.rest_positions[triangle[2]]) - corner);
    for (const std::uint32_t vertex : triangle) areas[vertex] += length(product) / 6;
  }
  return areas;
}

}  // namespace thinwall
