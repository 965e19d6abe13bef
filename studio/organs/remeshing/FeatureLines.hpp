#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "studio/organs/remeshing/TriangleSurface.hpp"

namespace thinwall {

/// The lines of a surface that remeshing keeps: its borders and its creases.
class FeatureLines {
 public:
  FeatureLines() = default;

  /// Borders, and the edges across which the normal turns by more than `crease_angle` (radians). Creases that hang
  /// together over less than `least_length` (metres) are rough spots and do not count, nor do edges of triangles with
  /// an angle below 10 degrees whose normal no neighbour beside shares to 3 degrees. Ends, branches and kinks of more
  /// than `crease_angle` are corners.
  FeatureLines(const TriangleSurface& surface, double crease_angle, double least_length);

  /// Makes a vertex of the surface a corner, on a line or off all of them, as a peak is.
  void keep(int vertex) { corners_[vertex] = true; }
  /// Makes a line of an edge of the surface, with corners at both ends.
  void keep(const TriangleSurface& surface, int a, int b);

  bool empty() const { return lines_.empty(); }
  std::size_t edge_count() const;

  bool is_on_line(int vertex) const { return vertex < count() && !neighbours_[vertex].empty(); }
  bool is_corner(int vertex) const { return vertex < count() && corners_[vertex]; }
  bool has_edge(int a, int b) const;
  /// The vertices beside one on its lines, ascending.
  const std::vector<int>& neighbours(int vertex) const { return neighbours_[vertex]; }
  /// Which line an edge of them is part of: lines go from corner to corner, or close.
  int line_of(int a, int b) const;

  /// Keeps step with the surface: an edge was split, or b merged into a.
  void split(int a, int b, int middle);
  void collapse(int a, int b);

  /// The closest point of a line as it was at first, where it runs about along `direction`.
  Eigen::Vector3d project(const Eigen::Vector3d& point, const Eigen::Vector3d& direction, int line) const;

 private:
  using Segment = std::array<Eigen::Vector3d, 2>;

  int count() const { return static_cast<int>(neighbours_.size()); }
  /// Of b among the neighbours of a, which must have it.
  std::ptrdiff_t place_of(int a, int b) const;
  void join(int a, int b, int line);
  void part(int a, int b);
  void drop_short_creases(const TriangleSurface& surface, double least_length,
                          std::vector<std::array<int, 2>>& creases) const;
  void mark_corners(const TriangleSurface& surface, double crease_angle);
  /// Makes a line of the edges on from one until a corner or the line itself is met; nothing where it is of one
  /// already.
  void follow(const TriangleSurface& surface, int from, int to);

  std::vector<std::vector<int>> neighbours_;  // (vertices), ascending
  std::vector<std::vector<int>> line_of_;     // (vertices), of the edge to each neighbour; -1 for none yet
  std::vector<bool> corners_;                 // (vertices)
  std::vector<std::vector<Segment>> lines_;   // (lines), as they were at first, metres
};

}  // namespace thinwall
