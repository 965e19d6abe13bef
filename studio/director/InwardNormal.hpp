#pragma once

#include <Eigen/Core>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// The mean inward normal of a body's stress-free surface along the path of a cut, by length: unit. Zero where the
/// surface cannot be made or has no such path, of which the run itself tells.
Eigen::Vector3d inward_normal(const BodyScenario& body, const InciseClip& clip);

}  // namespace thinwall
