#pragma once

#include <Eigen/Geometry>

namespace thinwall {

/// Sine of the smallest angle that is not taken for parallel: a thousandth of a degree.
constexpr double kParallel = 1.7e-5;

/// Whether two vectors, neither of which is zero, lie along one line.
inline bool are_parallel(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.normalized().cross(b.normalized()).norm() < kParallel;
}

}  // namespace thinwall
