#pragma once

#include <limits>

#include "engine/material/WallLaw.hpp"

namespace thinwall {

/// Derivatives of a strain energy W(I1, d) of the in-plane invariants I1 = tr C and d = det C, pascal.
struct InvariantDerivatives {
  double energy;           // W
  double by_trace;         // dW/dI1
  double by_det;           // dW/dd
  double trace_det;        // d2W/dI1 dd
  double det_det;          // d2W/dd2
  double trace_trace = 0;  // d2W/dI1^2
};

/// S = 2 (W_1 1 + W_d cof C) and its derivative.
/// With e = (E11, E22, 2 E12): dI1/de = 2 (1, 1, 0), dd/de = 2 cof C, d(cof C)/de constant.
inline WallLawResponse isotropic_response(const InvariantDerivatives& w, const Eigen::Vector3d& c) {
  const Eigen::Vector3d identity(1, 1, 0);
  const Eigen::Vector3d cofactor(c[1], c[0], -c[2]);
  Eigen::Matrix3d cofactor_derivative;
  cofactor_derivative << 0, 2, 0, 2, 0, 0, 0, 0, -1;
  WallLawResponse response;
  response.energy = w.energy;
  response.second_piola_kirchhoff = 2 * (w.by_trace * identity + w.by_det * cofactor);
  response.tangent = 4 * w.trace_trace * identity * identity.transpose() +
                     4 * w.trace_det * (identity * cofactor.transpose() + cofactor * identity.transpose()) +
                     4 * w.det_det * cofactor * cofactor.transpose() + 2 * w.by_det * cofactor_derivative;
  return response;
}

/// The answer where a law's energy is infinite.
inline WallLawResponse beyond_the_law() {
  return {.energy = std::numeric_limits<double>::infinity(),
          .second_piola_kirchhoff = Eigen::Vector3d::Zero(),
          .tangent = Eigen::Matrix3d::Zero()};
}

}  // namespace thinwall
