#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/equilibrium/BodyModel.hpp"

namespace thinwall {

/// The part of the wall that each vertex hangs together with, (vertices), numbered from 0 by first triangle. Caps hold
/// nothing together. Vertices of no triangle go with the first part.
std::vector<int> wall_parts(const BodyModel& model);

/// Finds the rigid motions that nothing prevents, a set for each part of the wall, and the three vertices far from each
/// other whose springs hold the factorised matrix of such a part. They are those of the body as it is at `position`,
/// (unknowns), metres, and held there: a piece that is cut out stays where it was when nothing else moves it.
void hold_rigid_motions(BodyModel& model, const Eigen::VectorXd& position);

}  // namespace thinwall
