#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/contact/SelfIntersections.hpp"

namespace thinwall {

/// All edges against all triangles that share no vertex with them, see `passes_through`: owes nothing to trees of
/// boxes. `position`: (3 vertices), metres.
std::vector<SurfaceIntersection> surface_intersections(std::span<const Eigen::Vector3i> triangles,
                                                       const Eigen::VectorXd& position);

}  // namespace thinwall
