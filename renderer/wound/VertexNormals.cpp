#include "renderer/wound/VertexNormals.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thinwall {

std::vector<Vector3> vertex_normals(std::span<const Float3> positions, std::span<const Triangle> triangles) {
  std::vector<Vector3> normals(positions.size());
  for (const Triangle& triangle : triangles) {
    Vector3 at[3];
    for (std::size_t k = 0; k < 3; ++k) at[k] = vector3(positions[triangle[k]]);
    const Vector3 product = cross(at[1] - at[0], at[2] - at[0]);
    const double size = length(product);
    if (!(size > 0)) continue;
    const double first = std::atan2(size, dot(at[1] - at[0], at[2] - at[0]));
    const double second = std::atan2(size, dot(at[2] - at[1], at[0] - at[1]));
    const double angles[3] = {first, second, std::max(0.0, std::numbers::pi - first - second)};
    for (std::size_t k = 0; k < 3; ++k) normals[triangle[k]] = normals[triangle[k]] + (angles[k] / size) * product;
  }
  for (Vector3& normal : normals) normal = normalized(normal);
  return normals;
}

}  // namespace thinwall
