#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace thinwall {

/// An edge and a triangle of a surface that pass through each other.
struct SurfaceIntersection {
  std::array<int, 2> edge;  // vertices, the lower number first
  int triangle;

  auto operator<=>(const SurfaceIntersection&) const = default;
};

/// Whether an edge passes through a triangle or its sides, by the signs of the volumes that its ends and the corners
/// span: owes nothing to distances. An edge that ends in the triangle does not.
bool passes_through(const std::array<Eigen::Vector3d, 2>& edge, const std::array<Eigen::Vector3d, 3>& triangle);

/// All edges of a surface that pass through triangles which share no vertex with them, ascending. `position`:
/// (3 vertices), of any unit.
std::vector<SurfaceIntersection> self_intersections(std::span<const Eigen::Vector3i> triangles,
                                                    const Eigen::VectorXd& position);

}  // namespace thinwall
