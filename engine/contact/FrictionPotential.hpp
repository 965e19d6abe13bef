#pragma once

#include <Eigen/Core>

namespace thinwall {

/// Energy of friction at one place with its derivatives by the place of the wall.
struct FrictionTerms {
  double energy = 0;                                   // joule
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  // newton, along the slip; the force on the wall is its opposite
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();   // newton / metre, positive semidefinite
};

/// Coulomb's law between a place of a wall and a tool, for a given normal force: with s the slip of the wall along the
/// tool, in the tangent plane,
///
///     limit |s|^2 / (2 give)    while |s| <= give (it sticks),
///     limit (|s| - give / 2)    beyond (it slides),
///
/// convex and once differentiable. The force never exceeds the limit, and while the wall sticks the spring remembers
/// where it did, so that nothing creeps: what is left of the slip after a step is its elastic part.
struct FrictionPotential {
  double limit = 0;    // newton, coefficient of friction times the normal force
  double give = 1e-6;  // metres

  double stiffness() const { return limit / give; }  // newton / metre
  bool sticks(const Eigen::Vector3d& slip) const { return slip.norm() <= give; }
  /// Part of the slip that the spring gives back, metres.
  Eigen::Vector3d elastic_part(const Eigen::Vector3d& slip) const;
  /// `normal`: unit, across which nothing slips; `slip` is tangential. `estimate`: what the force is taken to be, at
  /// most the limit; the Hessian is that of the energy when it is the gradient.
  FrictionTerms at(const Eigen::Vector3d& slip, const Eigen::Vector3d& normal, const Eigen::Vector3d& estimate) const;
  /// The estimate after a change of the slip. Newton's method on slip and force together (Chan, Golub and Mulet 1999,
  /// for total variation): as long as the force has not caught up with a slip that went too far, the Hessian keeps
  /// stiffness along it, without which places that begin to slide one after the other never settle.
  Eigen::Vector3d next_estimate(const Eigen::Vector3d& slip, const Eigen::Vector3d& change,
                                const Eigen::Vector3d& estimate) const;
};

}  // namespace thinwall
