#pragma once

#include <Eigen/Core>
#include <span>

namespace thinwall {

/// A point of a triangulated surface.
struct SurfacePoint {
  int triangle = 0;                                   // index
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  // barycentric, sum 1
};

/// A vertex as a point of the first triangle that has it. Asserts that one has.
SurfacePoint point_at(std::span<const Eigen::Vector3i> triangles, int vertex);

}  // namespace thinwall
