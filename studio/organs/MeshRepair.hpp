#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {

/// A surface under repair; each step keeps the order of what stays.
struct RawSurface {
  std::vector<Eigen::Vector3d> vertices;   // (vertices x 3), any unit
  std::vector<Eigen::Vector3i> triangles;  // (triangles x 3)
  std::vector<int> parts;                  // (triangles), which part of the file each comes from
};

/// Which triangles meet where, as they are.
MeshTopology topology_of_surface(const RawSurface& surface);

/// Length of the bounding box's diagonal; 0 without vertices.
double extent_of(const RawSurface& surface);

/// Keeps the triangles that are marked, (triangles); gives how many were not.
int keep_marked(RawSurface& surface, const std::vector<bool>& keep);

/// Makes vertices nearer than `tolerance` to an earlier one the same as that one. Gives how many were at another place;
/// those at the very same place are no sign of anything, for some formats cannot share a vertex between triangles.
int weld_vertices(RawSurface& surface, double tolerance);

/// Removes triangles with a corner twice, and those that repeat an earlier triangle's corners. Gives how many.
int remove_collapsed_triangles(RawSurface& surface);
int remove_repeated_triangles(RawSurface& surface);

/// Triangles lower than `tolerance` over their longest edge have no area to speak of. Where a neighbour shares that
/// edge, the edge is turned, so that no gap is torn; otherwise the triangle is removed. Gives how many were treated.
int remove_flat_triangles(RawSurface& surface, double tolerance);

/// Removes vertices that no triangle uses. Gives how many.
int remove_unused_vertices(RawSurface& surface);

struct OrientationResult {
  int turned = 0;          // triangles that were turned against their neighbours
  int turned_inside = 0;   // components that faced inwards as a whole
  bool orientable = true;  // false: like a Moebius band, no orientation agrees everywhere
};

/// Turns the triangles of each component to agree with most of its area.
OrientationResult make_agree(RawSurface& surface);

/// Makes triangles agree, then turns each component outwards: the enclosed volume, open loops closed by fans, is
/// positive. A component that encloses nothing keeps the sense of most of its area.
OrientationResult orient_outwards(RawSurface& surface);

/// A part of the surface joined across edges.
struct SurfaceComponent {
  int triangles = 0;
  double area = 0;
};

/// In the order of their first triangles.
std::vector<SurfaceComponent> components_of(const RawSurface& surface);

/// Removes all components but one.
void keep_component(RawSurface& surface, int component);

}  // namespace thinwall
