#pragma once

#include "engine/material/WallLaw.hpp"

namespace thinwall {

/// The in-plane tensor C = (C11, C22, C12) in its principal axes.
struct PrincipalFrame {
  double first, second;     // squares of the principal stretches, first >= second
  double difference;        // first - second, without cancellation where they are nearly equal
  Eigen::Matrix3d turning;  // takes (E11, E22, 2 E12) to the principal axes; its transpose brings stresses back
};

PrincipalFrame principal_frame(const Eigen::Vector3d& right_cauchy_green);

/// Derivatives of a strain energy of the squares c1, c2 of the principal stretches, pascal.
struct PrincipalDerivatives {
  double energy;
  double by_first, by_second;  // dW/dc1, dW/dc2
  double first_first, first_second, second_second;
  double slope_ratio;  // (dW/dc1 - dW/dc2) / (c1 - c2), its limit where they are equal
};

/// S = 2 dW/dci in the principal axes, brought back; the shear tangent there is (S1 - S2) / (c1 - c2) (Ogden 1984,
/// section 6.1).
WallLawResponse principal_response(const PrincipalDerivatives& derivatives, const PrincipalFrame& frame);

}  // namespace thinwall
