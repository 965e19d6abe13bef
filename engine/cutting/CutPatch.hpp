#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace thinwall {

/// Where a vertex may go without changing the surface.
enum class VertexFreedom {
  kFixed,
  kLine,  // along the straight edge between two flat pieces
  kFree   // within its flat piece
};

/// A corner of a triangle.
struct PatchCorner {
  int triangle = -1;
  int corner = 0;
};

/// The triangles around a vertex, counter-clockwise.
struct PatchFan {
  std::vector<PatchCorner> corners;
  bool closed = false;
  bool cut_off = false;  // by the frame of the patch
};

/// Part of a surface on which a cut is tried out: small, copied freely, with neighbours across edges. Side k of a
/// triangle joins its corners k and k + 1. A facet is a flat piece of the original surface; only within it are edges
/// flipped and vertices moved.
struct CutPatch {
  static constexpr int kBorder = -1;  // neighbour across an open edge that was there before any cut
  static constexpr int kFrame = -2;   // neighbour outside the patch
  static constexpr int kLip = -3;     // neighbour across an open edge that a cut made
  static constexpr bool is_open(int neighbour) { return neighbour == kBorder || neighbour == kLip; }

  std::vector<Eigen::Vector3d> positions;      // (vertices x 3), metres, rest
  std::vector<Eigen::Vector3d> placement;      // (first vertices x 3) or none, metres, where those of the surface are
  std::vector<int> vertex_triangle;            // (vertices), one of the triangles there
  std::vector<VertexFreedom> freedom;          // (vertices)
  std::vector<Eigen::Vector3d> line;           // (vertices x 3), unit, where the freedom is kLine
  std::vector<double> least_allowed;           // (vertices), radians, for angles of the triangles there
  std::vector<Eigen::Vector3i> triangles;      // (triangles x 3)
  std::vector<Eigen::Vector3i> neighbours;     // (triangles x 3), across the sides
  std::vector<int> facet;                      // (triangles), into normals
  std::vector<double> scale;                   // (triangles), metres, edge length of the original mesh there
  std::vector<char> frozen;                    // (triangles), the outermost ones stay as they are
  std::vector<char> changed;                   // (triangles)
  std::vector<std::array<char, 3>> on_path;    // (triangles x 3), sides that the new cut goes along
  std::vector<Eigen::Vector3d> facet_normals;  // (facets x 3), unit
  int splits = 0, flips = 0;
  bool path_goes_on = false;  // CutPath::goes_on

  int vertex_count() const { return static_cast<int>(positions.size()); }
  int triangle_count() const { return static_cast<int>(triangles.size()); }

  int corner_of(int triangle, int vertex) const;
  PatchFan fan_of(int vertex) const;
  /// The triangle and side that run from vertex `from` to vertex `to`; triangle -1 if none does.
  PatchCorner side_between(int from, int to) const;
  bool are_joined(int a, int b) const;

  /// Twice the area of p, q, r seen along the normal of a facet, signed.
  double orientation(int facet, const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r) const;
  Eigen::Vector3d barycentric(int triangle, const Eigen::Vector3d& position) const;
  /// The triangle of a facet that has a position, and its weights there; the nearest by least weight. -1: no triangle.
  std::pair<int, Eigen::Vector3d> locate(int facet, const Eigen::Vector3d& position) const;

  /// An edge that no flip may remove: it bounds a facet or the surface, or the cut goes along it.
  bool is_held(int triangle, int side) const;
  bool is_crease(int triangle, int side) const;

  /// Puts a vertex into a side, and so into the triangle across it.
  int split_side(int triangle, int side, const Eigen::Vector3d& position);
  int split_triangle(int triangle, const Eigen::Vector3d& position);
  /// The edge must not be held and the two triangles must form a convex quadrangle.
  void flip(int triangle, int side);
  bool can_flip(int triangle, int side) const;
  void set_on_path(int a, int b);

  /// Finds where vertices from `first` on may go: anywhere within one facet, along a straight crease between two, else
  /// nowhere.
  void find_freedom(int first);
  double mean_edge(int triangle) const;   // metres
  double allowed_at(int triangle) const;  // radians, the least that is allowed at one of its vertices

 private:
  int add_vertex(const Eigen::Vector3d& position, VertexFreedom its_freedom, double allowed);
  int add_triangle_like(int triangle);
  void join(int triangle, int side, int neighbour);
};

}  // namespace thinwall
