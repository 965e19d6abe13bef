#pragma once

#include "engine/equilibrium/Equilibrium.hpp"

namespace thinwall {

// Each adds to terms that hold the wall's already: to energies, gradient and Hessian.

/// Weight of the wall.
void add_weight(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                EquilibriumTerms& terms);

/// Weight and inertia of the fluid, as a pressure that rises along gravity less the fluid's acceleration: density
/// (g - a) . (x - level). A chamber's own pressure is the one at its level, the centroid of the stress-free shape, and
/// moments count from there too. Of the Hessian of the inertia only the sparse part: the outer products of the moments'
/// gradients border the matrix.
void add_fluid_weight(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                      EquilibriumTerms& terms);

/// Loads. Follower pressure has the force p A n / 3 at each corner; its Hessian is that of the volume under the
/// triangles, which is exact but at free borders, where the exact one is not symmetric. A moment is conjugate to the
/// rotation of its levers about its axis, which is fixed.
void add_loads(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
               EquilibriumTerms& terms);

}  // namespace thinwall
