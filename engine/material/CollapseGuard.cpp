#include "engine/material/CollapseGuard.hpp"

#include <cmath>

namespace thinwall {
namespace {

/// Of the modulus: enough for the force of a wall that is pressed along one direction to grow all the way, for any
/// Poisson's ratio.
constexpr double kPart = 0.1;

}  // namespace

void guard_against_collapse(double modulus, const Eigen::Vector3d& c, WallLawResponse& response) {
  const double d = c[0] * c[1] - c[2] * c[2];
  if (d >= kGuardedDeterminant) return;
  const double depth = std::log(kGuardedDeterminant / d), factor = kPart * modulus;
  const double slope = -3 * factor * depth * depth / d;                 // by det C
  const double curvature = 3 * factor * depth * (2 + depth) / (d * d);  // the same
  const Eigen::Vector3d by_strain(2 * c[1], 2 * c[0], -2 * c[2]);       // of det C by (E11, E22, 2 E12)
  Eigen::Matrix3d second_by_strain;
  second_by_strain << 0, 4, 0, 4, 0, 0, 0, 0, -2;
  response.energy += factor * depth * depth * depth;
  response.second_piola_kirchhoff += slope * by_strain;
  response.tangent += curvature * by_strain * by_strain.transpose() + slope * second_by_strain;
}

}  // namespace thinwall
