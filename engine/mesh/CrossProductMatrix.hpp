#pragma once

#include <Eigen/Core>

namespace thinwall {

/// The matrix [v] with [v] w = v x w.
inline Eigen::Matrix3d cross_product_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

}  // namespace thinwall
