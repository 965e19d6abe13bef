#include "studio/director/BodyExtent.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace thinwall {
namespace {

/// A surface winds around a point more often than this where the point lies inside.
constexpr double kInside = 0.5;

}  // namespace

double extent_along(const SurfaceView& surface, const Eigen::Vector3d& direction) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Eigen::Vector3i& vertices : surface.triangles) {
    for (const int vertex : vertices) {
      const double height = direction.dot(surface.position.segment<3>(3 * vertex));
      least = std::min(least, height);
      most = std::max(most, height);
    }
  }
  return surface.triangles.empty() ? 0 : most - least;
}

Eigen::AlignedBox3d box_of(const SurfaceView& surface) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3i& triangle : surface.triangles) {
    for (const int vertex : triangle) box.extend(surface.position.segment<3>(3 * vertex));
  }
  return box;
}

double winding_number(const SurfaceView& surface, const Eigen::Vector3d& point) {
  double sum = 0;
  for (const Eigen::Vector3i& vertices : surface.triangles) {
    const Eigen::Vector3d a = surface.position.segment<3>(3 * vertices[0]) - point;
    const Eigen::Vector3d b = surface.position.segment<3>(3 * vertices[1]) - point;
    const Eigen::Vector3d c = surface.position.segment<3>(3 * vertices[2]) - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (4 * std::numbers::pi);
}

bool is_inside(const SurfaceView& surface, const Eigen::Vector3d& point) {
  return !surface.open && winding_number(surface, point) > kInside;
}

}  // namespace thinwall
