#include "renderer/annotation/MaterialPoint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thinwall {
namespace {

/// The point of segment ab nearest to p, as the part of the way from a to b.
double nearest_part(Vector3 a, Vector3 b, Vector3 p) {
  const Vector3 along = b - a;
  const double squared = dot(along, along);
  return squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
}

/// Barycentric weights of the point of triangle abc nearest to p: the foot of the perpendicular where it lies inside,
/// else the nearest point of the sides.
std::array<double, 3> nearest_weights(Vector3 a, Vector3 b, Vector3 c, Vector3 p) {
  const Vector3 normal = cross(b - a, c - a);
  const double squared = dot(normal, normal);
  if (squared > 0) {
    const double at_a = dot(cross(b - p, c - p), normal) / squared;
    const double at_b = dot(cross(c - p, a - p), normal) / squared;
    const double at_c = 1 - at_a - at_b;
    if (at_a >= 0 && at_b >= 0 && at_c >= 0) return {at_a, at_b, at_c};
  }
  const std::array<Vector3, 3> corners = {a, b, c};
  std::array<double, 3> best = {1, 0, 0};
  double smallest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const double part = nearest_part(corners[i], corners[next], p);
    const Vector3 off = corners[i] + part * (corners[next] - corners[i]) - p;
    if (dot(off, off) >= smallest) continue;
    smallest = dot(off, off);
    best = {0, 0, 0};
    best[i] = 1 - part;
    best[next] = part;
  }
  return best;
}

Vector3 weighted(const std::vector<Float3>& positions, const Triangle& triangle, const std::array<double, 3>& weights) {
  return weights[0] * vector3(positions[triangle[0]]) + weights[1] * vector3(positions[triangle[1]]) +
         weights[2] * vector3(positions[triangle[2]]);
}

/// Where the segment from `start` over `span` meets triangle abc, as part of the span (Moeller and Trumbore 1997);
/// nothing when it does not.
std::optional<double> crossing(Vector3 start, Vector3 span, Vector3 a, Vector3 b, Vector3 c) {
  const Vector3 ab = b - a, ac = c - a;
  const Vector3 across = cross(span, ac);
  const double determinant = dot(ab, across);
  if (determinant == 0) return std::nullopt;
  const Vector3 from = start - a;
  const double u = dot(from, across) / determinant;
  const Vector3 turned = cross(from, ab);
  const double v = dot(span, turned) / determinant;
  if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
  const double part = dot(ac, turned) / determinant;
  return part > 0 && part < 1 ? std::optional(part) : std::nullopt;
}

}  // namespace

std::optional<MaterialPoint> nearest_material_point(const SnapshotTopology& topology, const Double3& place) {
  const Vector3 p = vector3(place);
  std::optional<MaterialPoint> best;
  double smallest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < topology.triangles.size(); ++i) {
    const auto& [a, b, c] = topology.triangles[i];
    const std::vector<Float3>& rest = topology.rest_positions;
    const std::array<double, 3> weights = nearest_weights(vector3(rest[a]), vector3(rest[b]), vector3(rest[c]), p);
    const Vector3 off = weighted(rest, topology.triangles[i], weights) - p;
    if (dot(off, off) >= smallest) continue;
    smallest = dot(off, off);
    best = MaterialPoint{.triangle = i, .weights = weights};
  }
  return best;
}

Vector3 place_of(const MaterialPoint& point, const SnapshotSurface& surface) {
  return weighted(surface.positions, surface.topology->triangles[point.triangle], point.weights);
}

Vector3 rest_place_of(const MaterialPoint& point, const SnapshotTopology& topology) {
  return weighted(topology.rest_positions, topology.triangles[point.triangle], point.weights);
}

std::optional<Vector3> first_met(const SnapshotSurface& surface, Vector3 at, Vector3 direction) {
  double reach = 0;
  for (const Float3& position : surface.positions) reach = std::max(reach, length(vector3(position) - at));
  const Vector3 start = at - (2 * reach) * direction, span = (4 * reach) * direction;
  std::optional<double> first;
  for (const auto& [a, b, c] : surface.topology->triangles) {
    const std::optional<double> part = crossing(start, span, vector3(surface.positions[a]),
                                                vector3(surface.positions[b]), vector3(surface.positions[c]));
    if (part && (!first || *part < *first)) first = part;
  }
  return first ? std::optional(start + *first * span) : std::nullopt;
}

bool is_hidden(Vector3 place, Vector3 eye, const Snapshot& snapshot, std::span<const ToolShape> tools) {
  // What is met just before the place is the surface that the place is on.
  constexpr double kOwnSurface = 1e-3;
  const Vector3 span = eye - place;
  for (const SnapshotSurface& surface : snapshot.surfaces) {
    for (const auto* triangles : {&surface.topology->triangles, &surface.topology->cap_triangles}) {
      for (const auto& [a, b, c] : *triangles) {
        const std::optional<double> part = crossing(place, span, vector3(surface.positions[a]),
                                                    vector3(surface.positions[b]), vector3(surface.positions[c]));
        if (part && *part > kOwnSurface) return true;
      }
    }
  }
  for (const ToolShape& tool : tools) {
    const auto at = [&](std::size_t corner) { return vector3(tool.vertices[tool.indices[corner]].position); };
    for (std::size_t i = 0; i + 2 < tool.indices.size(); i += 3) {
      const std::optional<double> part = crossing(place, span, at(i), at(i + 1), at(i + 2));
      if (part && *part > kOwnSurface) return true;
    }
  }
  return false;
}

}  // namespace thinwall
