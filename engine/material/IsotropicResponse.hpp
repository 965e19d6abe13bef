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
  const double first = c[1], second = c[0], shear = -c[2];  // of cof C
  WallLawResponse response;
  response.energy = w.energy;
  response.second_piola_kirchhoff = {2 * (w.by_trace + w.by_det * first), 2 * (w.by_trace + w.by_det * second),
                                     2 * w.by_det * shear};
  const double first_first = 4 * (w.trace_trace + 2 * w.trace_det * first + w.det_det * first * first);
  const double second_second = 4 * (w.trace_trace + 2 * w.trace_det * second + w.det_det * second * second);
  const double first_second =
      4 * (w.trace_trace + w.trace_det * (first + second) + w.det_det * first * second + w.by_det);
  const double first_shear = 4 * shear * (w.trace_det + w.det_det * first);
  const double second_shear = 4 * shear * (w.trace_det + w.det_det * second);
  const double shear_shear = 4 * w.det_det * shear * shear - 2 * w.by_det;
  response.tangent << first_first, first_second, first_shear,  //
      first_second, second_second, second_shear,               //
      first_shear, second_shear, shear_shear;
  return response;
}

/// The answer where a law's energy is infinite.
inline WallLawResponse beyond_the_law() {
  return {.energy = std::numeric_limits<double>::infinity(),
          .second_piola_kirchhoff = Eigen::Vector3d::Zero(),
          .tangent = Eigen::Matrix3d::Zero()};
}

}  // namespace thinwall
