#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/contact/SolidGap.hpp"

namespace thinwall {

/// A vertex, an edge or a triangle of a wall that keeps out of tools, seen as part of a triangle that has it.
struct ContactSite {
  SitePart part = SitePart::kFace;
  int triangle = 0;  // index
  int corner = 0;    // of the triangle: the vertex, or where the edge begins
  double area = 0;   // metres^2, its share of the wall's
};

/// Vertices that triangles use, then edges in the order in which triangles first have them, then triangles. `areas`:
/// (triangles), metres^2. A third of a triangle's area goes to each of its corners, and a third to each of its edges.
std::vector<ContactSite> contact_sites(int vertices, std::span<const Eigen::Vector3i> triangles,
                                       std::span<const double> areas);

}  // namespace thinwall
