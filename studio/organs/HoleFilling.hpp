#pragma once

#include <Eigen/Core>
#include <vector>

#include "studio/organs/MeshRepair.hpp"

namespace thinwall {

/// What counts as a small hole: so many edges at most, and so wide at most, of the surface's extent.
inline constexpr int kMostHoleEdges = 64;
inline constexpr double kWidestHole = 0.1;

struct FoundHole {
  int edges = 0;
  double width = 0;  // largest distance between two of its vertices, units of the surface
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // of its vertices
  bool filled = false;
};

/// Fills the small holes of an oriented surface with edges - 2 triangles each and tells of every hole. Small is also a
/// crack, however long: one with no more area than `crack_height` times its width. Of all ways to
/// do so without new vertices it takes the one whose sharpest bend is least and, among equal ones, whose triangles have
/// the least sum of squared edges; a way that would put an edge where one is already does not count, and a hole with no
/// other way stays. Each triangle is of the part that most of the hole's rim belongs to. After Liepa, Filling holes in
/// meshes, 2003.
std::vector<FoundHole> fill_small_holes(RawSurface& surface, double crack_height);

}  // namespace thinwall
