#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "engine/solver/Lanes.hpp"

namespace thinwall {

/// Contribution of one oriented triangle to the enclosed volume V = 1/6 sum x0 . (x1 x x2), metres^3.
inline double volume_of(const std::array<Eigen::Vector3d, 3>& corners) {
  return corners[0].dot(corners[1].cross(corners[2])) / 6;
}

/// Its gradient (x0, y0, z0, x1, ..., z2), metres^2. Over a closed surface the sums do not depend on the origin.
Eigen::Matrix<double, 9, 1> volume_gradient_of(const std::array<Eigen::Vector3d, 3>& corners);

/// The same of as many triangles as there are lanes, equal to the bit. `corners`: (9 x lanes), metres, of the corners
/// x0, y0, z0, x1, ..., z2; `gradients`: (9 x lanes), metres^2.
void volume_gradients_of(const double (&corners)[9][kLanes], double (&gradients)[9][kLanes]);

/// Its Hessian, metres: blocks of plus or minus [x]x / 6 (cross-product matrices), zero on the diagonal, symmetric.
Eigen::Matrix<double, 9, 9> volume_hessian_of(const std::array<Eigen::Vector3d, 3>& corners);

}  // namespace thinwall
