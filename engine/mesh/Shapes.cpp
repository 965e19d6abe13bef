#include "engine/mesh/Shapes.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/mesh/ShapePatterns.hpp"

namespace thinwall {
namespace {

using std::numbers::pi;

/// Height over side of an equilateral triangle.
const double kEquilateral = std::sqrt(3.0) / 2;

/// Part of a radius by which vertices on a circle may be off it.
constexpr double kRounding = 1e-12;

template <typename Map>
SurfaceMesh bend(const Pattern& pattern, const Map& map) {
  SurfaceMesh mesh;
  mesh.triangles = pattern.triangles;
  mesh.vertices.reserve(pattern.coordinates.size());
  for (const Eigen::Vector2d& coordinate : pattern.coordinates) {
    mesh.vertices.push_back(map(coordinate[0], coordinate[1]));
  }
  std::vector<int>& wall = mesh.groups["wall"];
  wall.resize(mesh.vertices.size());
  std::iota(wall.begin(), wall.end(), 0);
  return mesh;
}

/// Rows of vertices for a rectangle: strips counted across its width, segments along its length.
Division rows_for(double width, double length, int triangles, int least_strips) {
  return closest_division(
      triangles, least_strips, 2, 1, [](Division d) { return d.across * (2 * d.along + 1); },
      [&](Division d) { return (width / d.across) / (length / d.along) / kEquilateral; });
}

void add_cap(SurfaceMesh& mesh, const std::vector<int>& polygon) {
  const std::vector<Eigen::Vector3i> cap = fill_polygon(polygon);
  mesh.cap_triangles.insert(mesh.cap_triangles.end(), cap.begin(), cap.end());
}

void add_group(SurfaceMesh& mesh, const char* name, std::vector<int> vertices) {
  std::sort(vertices.begin(), vertices.end());
  mesh.groups[name] = std::move(vertices);
}

/// The groups of a ring's vertices on its two circles.
void add_circles(SurfaceMesh& mesh, double inner_radius, double radius) {
  std::vector<int> inner, outer;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const double reach = mesh.vertices[v].norm();
    if (std::abs(reach - inner_radius) < kRounding * radius) inner.push_back(static_cast<int>(v));
    if (std::abs(reach - radius) < kRounding * radius) outer.push_back(static_cast<int>(v));
  }
  add_group(mesh, "inner", inner);
  add_group(mesh, "outer", outer);
}

/// Caps at both ends of rows of vertices along y that follow one another clockwise about y; gives their group.
void close_ends(SurfaceMesh& mesh, const Pattern& pattern) {
  std::vector<int> front;
  std::vector<int> back;
  for (const std::vector<int>& row : pattern.rows) {
    back.push_back(row.front());
    front.push_back(row.back());
  }
  std::vector<int> ends = front;
  ends.insert(ends.end(), back.begin(), back.end());
  add_group(mesh, "ends", ends);
  add_cap(mesh, front);
  std::reverse(back.begin(), back.end());
  add_cap(mesh, back);
}

}  // namespace

SurfaceMesh make_hemisphere(double radius, int triangles) {
  assert(radius > 0);
  const Pattern pattern = centred_rings(4, closest_square(triangles, 4));
  SurfaceMesh mesh = bend(pattern, [&](double latitude, double turn) -> Eigen::Vector3d {
    // The rim lies on z = 0 exactly: it is found by its plane.
    const double height = latitude == 1 ? 0 : std::cos(pi / 2 * latitude);
    const double reach = std::sin(pi / 2 * latitude);
    return radius * Eigen::Vector3d(reach * std::cos(2 * pi * turn), reach * std::sin(2 * pi * turn), height);
  });
  std::vector<int> rim = pattern.rows.back();
  add_group(mesh, "base", rim);
  std::reverse(rim.begin(), rim.end());
  add_cap(mesh, rim);
  return mesh;
}

SurfaceMesh make_semicylinder(double radius, double length, int triangles) {
  assert(radius > 0 && length > 0);
  const Division division = rows_for(pi * radius, length, triangles, 2);
  const Pattern pattern = staggered_rows(division.across, division.along, false);
  SurfaceMesh mesh = bend(pattern, [&](double arc, double along) -> Eigen::Vector3d {
    const double angle = pi * arc;
    // The base lies on z = 0 exactly: it is found by its plane.
    const double height = std::abs(arc) == 0.5 ? 0 : std::cos(angle);
    return {radius * std::sin(angle), length * along, radius * height};
  });
  const std::vector<int>& left = pattern.rows.front();
  const std::vector<int>& right = pattern.rows.back();
  std::vector<int> base = left;
  base.insert(base.end(), right.begin(), right.end());
  add_group(mesh, "base", base);
  for (std::size_t k = 0; k + 1 < left.size(); ++k) {
    if (k % 2 == 0) {
      mesh.cap_triangles.emplace_back(left[k], left[k + 1], right[k + 1]);
      mesh.cap_triangles.emplace_back(left[k], right[k + 1], right[k]);
    } else {
      mesh.cap_triangles.emplace_back(left[k], left[k + 1], right[k]);
      mesh.cap_triangles.emplace_back(left[k + 1], right[k + 1], right[k]);
    }
  }
  close_ends(mesh, pattern);
  return mesh;
}

SurfaceMesh make_cylinder(double radius, double length, int triangles) {
  assert(radius > 0 && length > 0);
  const Division division = rows_for(2 * pi * radius, length, triangles, 4);
  const Pattern pattern = staggered_rows(division.across, division.along, true);
  SurfaceMesh mesh = bend(pattern, [&](double turn, double along) -> Eigen::Vector3d {
    const double angle = 2 * pi * turn;
    return {radius * std::sin(angle), length * along, radius * std::cos(angle)};
  });
  close_ends(mesh, pattern);
  return mesh;
}

SurfaceMesh make_sheet(double width, double length, int triangles) {
  assert(width > 0 && length > 0);
  const Division division = rows_for(width, length, triangles, 2);
  return bend(staggered_rows(division.across, division.along, false),
              [&](double across, double along) -> Eigen::Vector3d {
                return {width * across, length * along, 0};
              });
}

SurfaceMesh make_disc(double radius, int triangles) {
  assert(radius > 0);
  return bend(centred_rings(6, closest_square(triangles, 6)), [&](double reach, double turn) -> Eigen::Vector3d {
    return radius * reach * Eigen::Vector3d(std::cos(2 * pi * turn), std::sin(2 * pi * turn), 0);
  });
}

SurfaceMesh make_annulus(double inner_radius, double radius, int triangles) {
  assert(0 < inner_radius && inner_radius < radius);
  const double breadth = std::log(radius / inner_radius);  // of the ring in the plane that the logarithm maps it to
  const Division division = closest_division(
      triangles, 1, 1, 3, [](Division d) { return 2 * d.across * d.along; },
      [&](Division d) { return (breadth / d.across) / (2 * pi / d.along) / kEquilateral; });
  const Pattern pattern = staggered_circles(division.across, division.along);
  SurfaceMesh mesh = bend(pattern, [&](double outwards, double turn) -> Eigen::Vector3d {
    const double reach = outwards == 1 ? radius : inner_radius * std::exp(breadth * outwards);
    return reach * Eigen::Vector3d(std::cos(2 * pi * turn), std::sin(2 * pi * turn), 0);
  });
  add_circles(mesh, inner_radius, radius);
  return mesh;
}

SurfaceMesh make_slit_annulus(double inner_radius, double radius, int triangles) {
  assert(0 < inner_radius && inner_radius < radius);
  const double breadth = std::log(radius / inner_radius);
  const Division division = closest_division(
      triangles, 1, 1, 3, [](Division d) { return d.across * (2 * d.along + 1); },
      [&](Division d) { return (breadth / d.across) / (2 * pi / d.along) / kEquilateral; });
  const Pattern pattern = staggered_rows(division.across, division.along, false);
  SurfaceMesh mesh = bend(pattern, [&](double outwards, double turn) -> Eigen::Vector3d {
    const double reach = outwards == 0.5 ? radius : inner_radius * std::exp(breadth * (outwards + 0.5));
    // Both lips lie on y = 0 exactly.
    const double angle = turn == 0.5 ? 0 : 2 * pi * (turn + 0.5);
    return reach * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
  });
  std::vector<int> first, last;
  for (const std::vector<int>& row : pattern.rows) {
    first.push_back(row.front());
    last.push_back(row.back());
  }
  add_group(mesh, "slit_start", first);
  add_group(mesh, "slit_end", last);
  add_circles(mesh, inner_radius, radius);
  return mesh;
}

}  // namespace thinwall
