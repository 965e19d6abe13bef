#pragma once

#include <Eigen/Core>
#include <array>

namespace thinwall {

/// Two triangles (p, q, a) and (q, p, b) at the edge from p to q, in the order p, q, a, b.
using Hinge = std::array<Eigen::Vector3d, 4>;  // metres

/// Angle between the normals of the two triangles, radian in (-pi, pi]: zero where they lie in one plane, positive
/// where they bend towards their normals.
double hinge_angle(const Hinge& hinge);

/// Whether the angle is more than a quarter turn, told without finding it.
bool is_folded_back(const Hinge& hinge);

/// Whether one of the triangles, folded back upon the other, has gone through it from `before` to `after`: the angle
/// has then jumped by a whole turn.
bool passes_through(const Hinge& before, const Hinge& after);

/// With N the normal of (p, q, a) as twice its area, l the length of the edge and s the place of the foot of a along
/// it, d angle / da = l N / |N|^2, and - (1 - s) and - s times that by p and q; likewise at the other triangle
/// (Tamstorf and Grinspun 2013, Discrete bending forces and their Jacobians). The second derivative couples a and b
/// with the edge but not with each other.
struct HingeDerivatives {
  Eigen::Matrix<double, 12, 1> gradient;  // 1 / metre, of (p, q, a, b)
  Eigen::Matrix<double, 12, 12> hessian;  // 1 / metre^2, symmetric
};
HingeDerivatives hinge_derivatives(const Hinge& hinge);

}  // namespace thinwall
