#pragma once

#include "engine/equilibrium/Equilibrium.hpp"

namespace thinwall {

/// Of the wall's stiffness, the part by which a slack wall is held in statics: what nothing pulls then stays where it
/// was, and forces that bear are off by some hundred-thousandth of the stiffness times what the wall is strained by in
/// a step.
inline constexpr double kLeastMotion = 1e-5;

/// What the least motion of a triangle adds: the energy T / 2 (|grad (x - from)|^2 + |x - from|^2 / A) per rest area,
/// where A is that of the wall and T the part of its stiffness, and its derivatives with respect to the corners (x0,
/// y0, z0, x1, ..., z2): that of an even tension, and springs for motions as a whole, which may be free. Convex as a
/// tension field is, it leaves the equilibrium of one unique and presses nowhere: a part of the law's stiffness in its
/// place would press across wrinkles and fold the wall as finely as its triangles.
struct LeastMotionTerms {
  double energy;                         // joule
  Eigen::Matrix<double, 9, 1> gradient;  // newton
  Eigen::Matrix<double, 9, 9> hessian;   // newton / metre
};
LeastMotionTerms least_motion_terms(const BodyModel& model, const LeastMotion& motion, const Eigen::VectorXd& position,
                                    int triangle);

/// Adds that of all triangles, where there is one, to terms that hold the wall's already.
void add_least_motion(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                      EquilibriumTerms& terms);

}  // namespace thinwall
