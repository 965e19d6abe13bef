#pragma once

#include <Eigen/Core>
#include <array>

#include "engine/contact/ToolSolid.hpp"

namespace thinwall {

/// Where the signed distance from a solid is least on an edge or a triangle.
struct DeepestPoint {
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  // barycentric
  /// Corners that the point may move towards: three on the face, two on an edge, one at a corner.
  std::array<int, 3> corners = {0, 0, 0};
  int corner_count = 0;
};

/// On the edge that joins two corners of a triangle. The signed distance from a convex solid is convex, so that the
/// root of its monotone slope is enclosed and found to the last bits; of a ball it has a closed form. Of several
/// equally deep points it gives one. With the solid's crown the edge is taken to be crowned: the gap at part s of it
/// counts as larger by crown / 2 (s - 1/2)^2. Of an edge along a straight rim every point is equally deep, and the
/// deepest one would jump from one end of the rim to the other at the least tilt: no equilibrium would be found. So it
/// goes from end to end over tilts of some 1e-4, and the gap is off by less than a thousandth of the rim's radius.
DeepestPoint deepest_on_edge(const ToolSolid& solid, const std::array<Eigen::Vector3d, 3>& corners, int from, int to);

/// On the whole triangle: where the deepest point of the three edges does not become deeper inwards it is the one;
/// otherwise the deepest of the deepest points of chords, which is again a convex function of one number. From a ball
/// by `closest_point`.
DeepestPoint deepest_on_triangle(const ToolSolid& solid, const std::array<Eigen::Vector3d, 3>& corners);

}  // namespace thinwall
