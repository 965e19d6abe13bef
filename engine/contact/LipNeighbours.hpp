#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace thinwall {

/// For each vertex those on the other lip of a cut that were joined to it by an edge, or were it, before the wall was
/// cut there, (vertices), ascending. The lips of a cut are told by vertices with the same stress-free place.
/// `triangles`: of the wall; `rest_position`: (3 vertices), metres.
std::vector<std::vector<int>> neighbours_across_cuts(std::span<const Eigen::Vector3i> triangles,
                                                     const Eigen::VectorXd& rest_position);

}  // namespace thinwall
