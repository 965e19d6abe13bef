#include "renderer/wound/RestNormals.hpp"

#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

std::vector<Float3> rest_normals(const SnapshotTopology& topology) {
  std::vector<Vector3> sums(topology.rest_positions.size());
  for (const Triangle& triangle : topology.triangles) {
    const Vector3 a = vector3(topology.rest_positions[triangle[0]]);
    const Vector3 area =
        cross(vector3(topology.rest_positions[triangle[1]]) - a, vector3(topology.rest_positions[triangle[2]]) - a);
    for (const std::uint32_t vertex : triangle) sums[vertex] = sums[vertex] + area;
  }
  std::vector<Float3> normals;
  for (const Vector3& sum : sums) {
    const Vector3 n = normalized(sum);
    normals.push_back({static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
  }
  return normals;
}

}  // namespace thinwall
