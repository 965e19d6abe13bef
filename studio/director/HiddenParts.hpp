#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// For each unit vector along which a camera looks, the part of the places where tools are to come upon walls that
/// stress-free bodies hide from it, 0 to 1; scenery hides nothing, as a camera may be within it. 0 where no surface can
/// be made or no tool comes upon one, of which the run itself tells.
std::vector<double> hidden_parts(const Scenario& scenario, std::span<const Eigen::Vector3d> facings);

}  // namespace thinwall
