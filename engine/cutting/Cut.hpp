#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "engine/mesh/SurfacePoint.hpp"

namespace thinwall {

/// Where a surface is to be cut: a polyline on it. Consecutive points lie in one closed triangle or in one flat piece
/// of the surface. A path that begins or ends at an open border opens it there.
struct CutPath {
  std::optional<int> from = {};           // vertex that the path goes on from, such as the tip of an earlier cut
  std::vector<SurfacePoint> points = {};  // in order; the first is joined with `from`
  bool goes_on = false;                   // a cut rather stops short, and goes on later, than ends beside the path
};

struct CutOptions {
  double edge_length = 0;  // metres, wanted along the cut: larger triangles there are refined; 0: as they are
  double deviation = 0;    // metres: refined too where the cut would be farther from its path; 0: wherever it is
  std::vector<int> kept_vertices = {};   // vertices that keep their stress-free positions, such as fixed ones
  std::vector<int> kept_triangles = {};  // that stay as they are, as what presses on them would feel another surface
  // (vertices x 3) or none, metres, where the vertices are now: triangles that lie well on the stress-free surface may
  // span a fold of the wall as it is, and be strained there without measure. None such is made.
  std::vector<Eigen::Vector3d> placement = {};
};

/// Where a vertex lies on the surface as it was before the cut.
struct VertexSource {
  int vertex = 0;
  SurfacePoint before;
  std::optional<int> original = {};  // of the other lip's node: the vertex that was doubled
};

/// A part of a triangle's rest area.
struct TriangleShare {
  int triangle = 0;  // of the surface before the cut
  double share = 0;
};

/// Which triangles of the surface before the cut lie where a triangle lies now.
struct TriangleSource {
  int triangle = 0;
  std::vector<TriangleShare> before;  // of its rest area; sum 1
};

/// The two sides of a cut: vertices in the order of the path. A tip is in both.
struct Lips {
  std::vector<int> left, right;  // equally many
};

/// What the mesh went through.
struct CutCounts {
  int splits = 0;            // vertices put into edges and faces
  int flips = 0;             // of edges between coplanar triangles
  int moved_vertices = 0;    // earlier ones, within their plane or along their straight edge
  int edge_paths = 0;        // 1: no new node fits in; the cut goes along edges
  double area_change = 0;    // metres^2, rest
  double volume_change = 0;  // metres^3, rest; what the changed triangles enclose with the origin
};

/// What a cut changed. Vertices keep their numbers and new ones follow. Triangles that are not named keep their
/// numbers, vertices and shapes; those that are named and older lie in the places of changed ones, and new ones follow.
struct Cut {
  std::vector<VertexSource> vertices;     // new ones, then moved ones
  std::vector<TriangleSource> triangles;  // changed and new ones, ascending
  std::vector<Lips> lips;                 // new ones
  std::optional<int> tip;                 // where the cut can go on; none where it ended at a border or at another cut
  double length = 0;                      // metres, rest, of the new cut; times the thickness: the new cut area
  std::vector<std::vector<int>> wound_loops;  // borders of wall and caps that have new lips, in their triangles' sense
  std::vector<int> separated;                 // components that this cut made
  int predicted_euler_change = 0;             // of the wall, from the path alone
  int euler_change = 0;                       // of the wall, as counted
  double deviation = 0;                       // metres, rest, largest distance between the path and the cut
  // The path from the tip to its end, on the new surface: too short to be cut yet, or too close to a border. The next
  // path goes on from the tip with these points and those after them.
  std::vector<SurfacePoint> rest;
  double least_angle = 0;          // radians, rest, of the neighbourhood
  double least_meeting_angle = 0;  // radians, at which the new cut meets itself, other cuts and borders; pi if not
  CutCounts counts;
};

}  // namespace thinwall
