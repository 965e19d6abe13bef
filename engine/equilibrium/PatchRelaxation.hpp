#pragma once

#include "engine/equilibrium/PatchEnergy.hpp"

namespace thinwall {

/// Where a body is, (unknowns), metres, once the unknowns of a patch have come to rest, from `position`, at which
/// `energy` was evaluated with its Hessian: Newton's method with a dense matrix, made convex by a part of the wall's
/// stiffness where it is not, and a line search for less energy or a smaller gradient on ways on which no pair of folds
/// meets. It ends where the gradient has fallen to `goal`, newton, or no better place is found.
Eigen::VectorXd relaxed(PatchEnergy& energy, const Eigen::VectorXd& position, double goal);

}  // namespace thinwall
