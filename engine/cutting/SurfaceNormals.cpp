#include "engine/cutting/SurfaceNormals.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace thinwall {
namespace {

/// Shorter than this, a mean of unit normals says nothing of a direction.
constexpr double kCancelled = 1e-6;

/// What the triangle adds to the normal of its corner k: its own, times its angle there.
std::array<Eigen::Vector3d, 3> weighted_normals(const SurfaceView& surface, const Eigen::Vector3i& triangle) {
  std::array<Eigen::Vector3d, 3> corners, weighted;
  for (int k = 0; k < 3; ++k) corners[k] = surface.position.segment<3>(3 * triangle[k]);
  const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double length = normal.norm();
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d next = corners[(k + 1) % 3] - corners[k], last = corners[(k + 2) % 3] - corners[k];
    weighted[k].setZero();
    if (length > 0) weighted[k] = std::atan2(length, next.dot(last)) / length * normal;
  }
  return weighted;
}

void make_unit(Eigen::Vector3d& normal) {
  if (normal.norm() > 0) normal.normalize();
}

/// `normals`: at the corners of the point's triangle.
Eigen::Vector3d between(const SurfaceView& surface, const std::array<Eigen::Vector3d, 3>& normals,
                        const SurfacePoint& point) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) sum += point.weights[k] * normals[k];
  if (sum.norm() > kCancelled) return sum.normalized();
  const auto [a, b, c] = corners_of(surface, point.triangle);
  return (b - a).cross(c - a).normalized();
}

}  // namespace

std::vector<Eigen::Vector3d> vertex_normals(const SurfaceView& surface) {
  std::vector<Eigen::Vector3d> normals(static_cast<std::size_t>(surface.position.size() / 3), Eigen::Vector3d::Zero());
  for (const Eigen::Vector3i& triangle : surface.triangles) {
    const std::array<Eigen::Vector3d, 3> weighted = weighted_normals(surface, triangle);
    for (int k = 0; k < 3; ++k) normals[triangle[k]] += weighted[k];
  }
  for (Eigen::Vector3d& normal : normals) make_unit(normal);
  return normals;
}

Eigen::Vector3d smooth_normal(const SurfaceView& surface, const std::vector<Eigen::Vector3d>& normals,
                              const SurfacePoint& point) {
  const Eigen::Vector3i& vertices = surface.triangles[point.triangle];
  return between(surface, {normals[vertices[0]], normals[vertices[1]], normals[vertices[2]]}, point);
}

Eigen::Vector3d smooth_normal(const SurfaceView& surface, const SurfacePoint& point) {
  const Eigen::Vector3i& vertices = surface.triangles[point.triangle];
  std::array<Eigen::Vector3d, 3> normals;
  normals.fill(Eigen::Vector3d::Zero());
  for (const Eigen::Vector3i& triangle : surface.triangles) {
    for (int k = 0; k < 3; ++k) {
      for (int corner = 0; corner < 3; ++corner) {
        if (triangle[corner] == vertices[k]) normals[k] += weighted_normals(surface, triangle)[corner];
      }
    }
  }
  for (Eigen::Vector3d& normal : normals) make_unit(normal);
  return between(surface, normals, point);
}

}  // namespace thinwall
