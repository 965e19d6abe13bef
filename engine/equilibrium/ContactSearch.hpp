#pragma once

#include <Eigen/Core>

#include "engine/equilibrium/Equilibrium.hpp"

namespace thinwall {

/// Adds to `terms.contacts` the sites of the wall that are near a solid of the problem, or that it presses on, in the
/// order of the solids and then of the sites. `position`: (unknowns), metres.
void find_contacts(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                   EquilibriumTerms& terms);

}  // namespace thinwall
