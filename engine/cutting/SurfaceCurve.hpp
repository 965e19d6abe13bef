#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/mesh/SurfacePoint.hpp"
#include "engine/tool/FirstContact.hpp"

namespace thinwall {

/// A line on a triangulated surface, straight within each triangle.
struct SurfaceCurve {
  std::vector<SurfacePoint> points;
  /// (points - 1), or (points) of a closed curve, whose first point follows the last: the triangle in which point k and
  /// the next one lie, on its edges and corners included. Each point's own triangle may be another one beside it.
  std::vector<int> triangles;
  bool closed = false;
};

/// Where a point of a surface is, metres.
inline Eigen::Vector3d position_of(const SurfaceView& surface, const SurfacePoint& point) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Eigen::Vector3i& vertices = surface.triangles[static_cast<std::size_t>(point.triangle)];
  for (int k = 0; k < 3; ++k) sum += point.weights[k] * surface.position.segment<3>(3 * vertices[k]);
  return sum;
}

/// Along a way over a surface, from each point straight to the next one, metres.
inline double length_of(const SurfaceView& surface, std::span<const SurfacePoint> way) {
  double length = 0;
  for (std::size_t k = 1; k < way.size(); ++k) {
    length += (position_of(surface, way[k]) - position_of(surface, way[k - 1])).norm();
  }
  return length;
}

/// The largest coordinate of a surface, metres: what its round-off is measured by.
inline double scale_of(const SurfaceView& surface) {
  return surface.position.size() == 0 ? 0 : surface.position.cwiseAbs().maxCoeff();
}

}  // namespace thinwall
