#include "engine/cutting/SurfaceNormals.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace thinwall {
namespace {

/// Shorter than this, a mean of unit normals says nothing of a direction.
constexpr double kCancelled = 1e-6;

}  // namespace

std::vector<Eigen::Vector3d> vertex_normals(const SurfaceView& surface) {
  std::vector<Eigen::Vector3d> normals(static_cast<std::size_t>(surface.position.size() / 3), Eigen::Vector3d::Zero());
  for (const Eigen::Vector3i& vertices : surface.triangles) {
    std::array<Eigen::Vector3d, 3> corners;
    for (int k = 0; k < 3; ++k) corners[k] = surface.position.segment<3>(3 * vertices[k]);
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double length = normal.norm();
    if (length == 0) continue;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d next = corners[(k + 1) % 3] - corners[k], last = corners[(k + 2) % 3] - corners[k];
      normals[vertices[k]] += std::atan2(length, next.dot(last)) / length * normal;
    }
  }
  for (Eigen::Vector3d& normal : normals) {
    if (normal.norm() > 0) normal.normalize();
  }
  return normals;
}

Eigen::Vector3d smooth_normal(const SurfaceView& surface, const std::vector<Eigen::Vector3d>& normals,
                              const SurfacePoint& point) {
  const Eigen::Vector3i& vertices = surface.triangles[point.triangle];
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) sum += point.weights[k] * normals[vertices[k]];
  if (sum.norm() > kCancelled) return sum.normalized();
  const Eigen::Vector3d origin = surface.position.segment<3>(3 * vertices[0]);
  const Eigen::Vector3d one = surface.position.segment<3>(3 * vertices[1]) - origin;
  const Eigen::Vector3d other = surface.position.segment<3>(3 * vertices[2]) - origin;
  return one.cross(other).normalized();
}

}  // namespace thinwall
