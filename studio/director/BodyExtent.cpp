#include "studio/director/BodyExtent.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/mesh/MeshMeasures.hpp"

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
    const auto corner = [&](int k) -> Eigen::Vector3d { return surface.position.segment<3>(3 * vertices[k]); };
    sum += solid_angle({corner(0), corner(1), corner(2)}, point);
  }
  return sum / (4 * std::numbers::pi);
}

bool is_inside(const SurfaceView& surface, const Eigen::Vector3d& point) {
  return !surface.open && winding_number(surface, point) > kInside;
}

}  // namespace thinwall
