#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace thinwall {

/// An edge and a triangle of a surface that pass through each other.
struct SurfaceIntersection {
  std::array<int, 2> edge;
  int triangle;
};

/// All edges against all triangles that share no vertex with them, by the signs of the volumes that they span: owes
/// nothing to distances. `position`: (3 vertices), metres. Touching without passing through is no intersection.
std::vector<SurfaceIntersection> surface_intersections(std::span<const Eigen::Vector3i> triangles,
                                                       const Eigen::VectorXd& position);

}  // namespace thinwall
