#pragma once

#include <Eigen/Core>
#include <array>

namespace thinwall {

/// The point of a triangle closest to another point.
struct ClosestPoint {
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  // barycentric
  /// Corners that the point may move towards: three on the face, two on an edge, one at a corner.
  std::array<int, 3> corners = {0, 0, 0};
  int corner_count = 0;
};

/// By the Voronoi regions of face, edges and corners (Ericson 2005, section 5.1.5).
ClosestPoint closest_point(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& point);

}  // namespace thinwall
