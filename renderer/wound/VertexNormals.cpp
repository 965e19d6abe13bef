#include "renderer/wound/VertexNormals.hpp"

#include <cmath>

namespace thinwall {

std::vector<Vector3> vertex_normals(std::span<const Float3> positions, std::span<const Triangle> triangles) {
  std::vector<Vector3> normals(positions.size());
  for (const Triangle& triangle : triangles) {
    Vector3 at[3];
    for (std::size_t k = 0; k < 3; ++k) at[k] = vector3(positions[triangle[k]]);
    const Vector3 product = cross(at[1] - at[0], at[2] - at[0]);
    const double size = length(product);
    if (!(size > 0)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const double along = dot(at[(k + 1) % 3] - at[k], at[(k + 2) % 3] - at[k]);
      normals[triangle[k]] = normals[triangle[k]] + (std::atan2(size, along) / size) * product;
    }
  }
  for (Vector3& normal : normals) normal = normalized(normal);
  return normals;
}

}  // namespace thinwall
