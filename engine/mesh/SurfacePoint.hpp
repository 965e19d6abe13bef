#pragma once

#include <Eigen/Core>

namespace thinwall {

/// A point of a triangulated surface.
struct SurfacePoint {
  int triangle = 0;                                   // index
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  // barycentric, sum 1
};

}  // namespace thinwall
