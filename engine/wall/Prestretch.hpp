#pragma once

#include <Eigen/Core>

namespace thinwall {

/// In-plane stretch of the given surface over the rest shape.
struct Prestretch {
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();  // direction of `first`, brought into the plane of each triangle
  double first = 1, second = 1;                      // stretches along it and across it
};

}  // namespace thinwall
