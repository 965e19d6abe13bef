#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

namespace thinwall {

/// A flat pattern of vertices and triangles that shapes are bent from. Triangles are counter-clockwise where the second
/// coordinate runs to the left of the first.
struct Pattern {
  std::vector<Eigen::Vector2d> coordinates;  // (vertices x 2)
  std::vector<Eigen::Vector3i> triangles;    // (triangles x 3)
  std::vector<std::vector<int>> rows;        // vertices of each row or ring, in order
};

/// strips + 1 straight rows of vertices, first coordinate -1/2 ... 1/2 from row to row, second -1/2 ... 1/2 along each;
/// symmetric to the last bit. Rows of even number have `segments` equal segments; those between them are shifted by
/// half a segment and have a half segment at either end. strips (2 segments + 1) triangles. When `wrapped` the last row
/// is the first; strips is even then.
Pattern staggered_rows(int strips, int segments, bool wrapped);

/// A centre and `rings` rings; ring k has sectors * k vertices. First coordinate: k / rings; second: the fraction of a
/// turn. sectors * rings^2 triangles.
Pattern centred_rings(int sectors, int rings);

/// rings + 1 closed circles of `around` vertices, each turned by half a spacing. First coordinate: the circle's number
/// / rings; second: the fraction of a turn. 2 around rings triangles.
Pattern staggered_circles(int rings, int around);

/// Triangles that fill a convex polygon without vertices of their own, in the polygon's sense: every second vertex is
/// cut off, again and again, which keeps triangles wider than a fan would.
std::vector<Eigen::Vector3i> fill_polygon(std::span<const int> polygon);

struct Division {
  int across = 1;
  int along = 1;
};

/// The division that comes nearest to the wanted number of triangles with triangles nearly equilateral: least
/// |log(count / wanted)| + log^2(aspect). `across` runs through least_across, least_across + step, ...; `count` must
/// grow with `along`. `aspect` is height / side of a triangle over that of an equilateral one.
Division closest_division(int wanted, int least_across, int step, int least_along,
                          const std::function<int(Division)>& count, const std::function<double(Division)>& aspect);

/// n >= 1 for which factor * n^2 is nearest to wanted.
int closest_square(int wanted, int factor);

}  // namespace thinwall
