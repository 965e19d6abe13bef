#pragma once

#include <array>
#include <vector>

#include "studio/organs/remeshing/TriangleSurface.hpp"

namespace thinwall {

/// A triangle surface, closed or with borders, whose edges can be split, collapsed and turned. Removed vertices and
/// triangles leave gaps in the numbering until the end. It must be an oriented manifold, and stays one.
class EditableSurface {
 public:
  explicit EditableSurface(TriangleSurface surface);

  std::vector<Eigen::Vector3d> positions;  // (vertices x 3), metres

  /// Without the gaps.
  TriangleSurface compact() const;

  int triangle_count() const { return triangle_count_; }
  const Eigen::Vector3i& triangle(int t) const { return triangles_[t]; }
  /// Triangles at a vertex, none for a removed one.
  const std::vector<int>& triangles_at(int vertex) const { return fans_[vertex]; }

  /// All edges, the lower vertex first, ascending.
  std::vector<std::array<int, 2>> edges() const;
  bool has_edge(int a, int b) const;
  /// Whether the edge has one triangle only.
  bool is_border(int a, int b) const;
  bool is_at_border(int vertex) const;
  /// The far corners of the two triangles at an edge: of the one that runs a to b, then of the other; -1 at a border.
  std::array<int, 2> far_corners(int a, int b) const;
  int valence(int vertex) const { return static_cast<int>(fans_[vertex].size()); }

  /// Puts a new vertex on an edge; gives its index.
  int split(int a, int b, const Eigen::Vector3d& position);

  /// Whether merging the ends of an edge leaves a manifold: they have the far corners as neighbours in common and no
  /// others, and it does not join two borders.
  bool may_collapse(int a, int b) const;
  /// Merges b into a, which moves to `position`.
  void collapse(int a, int b, const Eigen::Vector3d& position);

  /// Whether the edge between the far corners is not there yet, and no vertex would keep too few triangles. Borders may
  /// not be turned.
  bool may_turn(int a, int b) const;
  /// Replaces an edge by that between the far corners.
  void turn(int a, int b);

 private:
  int triangle_along(int a, int b) const;
  std::vector<int> neighbours(int vertex) const;
  bool may_lose_triangle(int vertex) const;
  void replace_corner(int t, int from, int to);
  void drop_from_fan(int vertex, int t);
  void remove(int t);

  std::vector<Eigen::Vector3i> triangles_;  // a removed one has corners -1
  std::vector<std::vector<int>> fans_;
  int triangle_count_ = 0;
};

}  // namespace thinwall
