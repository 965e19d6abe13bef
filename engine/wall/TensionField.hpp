#pragma once

#include "engine/material/WallLaw.hpp"

namespace thinwall {

/// Part of the law's stiffness at rest that a tension field keeps everywhere, as a quadratic energy of the strain,
/// where a wall without tension moves: without it steps have to be divided.
inline constexpr double kSlackStiffness = 1e-5;

/// The law's answer for a wall without bending stiffness, which wrinkles infinitely finely instead of taking
/// compression: the least energy over all metrics that fine wrinkles can hide, min of W(C + D) over D >= 0 (Pipkin
/// 1994, the quasiconvex relaxation). Taut where S(C) >= 0: the law itself. Slack where C <= 1: none. Between them
/// D = beta n n^T with S n = 0: uniaxial tension across the wrinkles' direction n, for any anisotropy. Energy and
/// stress are continuous, the tangent is the exact one of each regime. Adds slack_stiffness / 2 e . T0 e with the law's
/// tangent T0 at rest. `right_cauchy_green` = (C11, C22, C12).
WallLawResponse tension_field_response(const Material& material, const Eigen::Vector3d& right_cauchy_green,
                                       double slack_stiffness);

/// The law's answer, relaxed where asked for.
inline WallLawResponse wall_response(const Material& material, const Eigen::Vector3d& right_cauchy_green,
                                     bool tension_field, double slack_stiffness) {
  return tension_field ? tension_field_response(material, right_cauchy_green, slack_stiffness)
                       : material.law->respond(material.parameters, right_cauchy_green);
}

}  // namespace thinwall
