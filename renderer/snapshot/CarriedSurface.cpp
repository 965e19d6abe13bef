#include "renderer/snapshot/CarriedSurface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thinwall {
namespace {

/// Places of the stress-free surface nearer to each other than this part of a triangle's size are the same: positions
/// have 24 bits.
constexpr double kSamePlace = 1e-4;

struct Place {
  Triangle corners{};
  Double3 weights{};
};

Double3 difference(const Float3& a, const Float3& b) {
  return {double{a[0]} - b[0], double{a[1]} - b[1], double{a[2]} - b[2]};
}

double dot(const Double3& a, const Double3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Weights of the point of a triangle's plane below `point`, those outside brought to the border.
Double3 weights_below(const Float3& point, const Float3& a, const Float3& b, const Float3& c) {
  const Double3 u = difference(b, a), v = difference(c, a), w = difference(point, a);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0)) return {1, 0, 0};
  const double second = std::max(0.0, (vv * uw - uv * vw) / determinant);
  const double third = std::max(0.0, (uu * vw - uv * uw) / determinant);
  const double first = std::max(0.0, 1 - (vv * uw - uv * vw + uu * vw - uv * uw) / determinant);
  const double sum = first + second + third;
  return {first / sum, second / sum, third / sum};
}

Float3 at(const Place& place, const std::vector<Float3>& positions) {
  Float3 point{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double sum = 0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      sum += place.weights[corner] * positions[place.corners[corner]][axis];
    }
    point[axis] = static_cast<float>(sum);
  }
  return point;
}

/// The place of the earlier stress-free surface that is nearest to a vertex of the later one.
Place place_of(std::size_t vertex, const SnapshotSurface& earlier, const SnapshotSurface& later) {
  const std::vector<Float3>& rest = earlier.topology->rest_positions;
  const Float3& wanted = later.topology->rest_positions[vertex];
  Place best;
  double nearest = std::numeric_limits<double>::infinity(), best_motion = nearest;
  for (const Triangle& triangle : earlier.topology->triangles) {
    const Float3 &a = rest[triangle[0]], &b = rest[triangle[1]], &c = rest[triangle[2]];
    const Double3 side = difference(b, a), offset = difference(wanted, a), other = difference(c, a);
    const double size = std::sqrt(std::max(dot(side, side), dot(other, other)));
    if (std::sqrt(dot(offset, offset)) > nearest + 2 * size) continue;
    const Place place{.corners = triangle, .weights = weights_below(wanted, a, b, c)};
    const Double3 miss = difference(at(place, rest), wanted);
    const Double3 motion = difference(at(place, earlier.positions), later.positions[vertex]);
    const double distance = std::sqrt(dot(miss, miss)), moved = dot(motion, motion);
    const double same = kSamePlace * size;
    if (distance > nearest + same || (distance > nearest - same && moved >= best_motion)) continue;
    nearest = distance;
    best_motion = moved;
    best = place;
  }
  return best;
}

}  // namespace

SnapshotSurface carried_over(const SnapshotSurface& earlier, const SnapshotSurface& later) {
  const SnapshotTopology &before = *earlier.topology, &after = *later.topology;
  SnapshotSurface carried = later;
  for (std::size_t v = 0; v < after.rest_positions.size(); ++v) {
    const bool stays = v < before.rest_positions.size() && before.rest_positions[v] == after.rest_positions[v];
    const auto vertex = static_cast<std::uint32_t>(v);
    const Place place =
        stays ? Place{.corners = {vertex, vertex, vertex}, .weights = {1, 0, 0}} : place_of(v, earlier, later);
    carried.positions[v] = at(place, earlier.positions);
    for (std::size_t f = 0; f < carried.fields.size() && f < earlier.fields.size(); ++f) {
      if (carried.fields[f].location != FieldLocation::kVertex) continue;
      double value = 0;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        value += place.weights[corner] * earlier.fields[f].values[place.corners[corner]];
      }
      carried.fields[f].values[v] = static_cast<float>(value);
    }
  }
  for (std::size_t f = 0; f < carried.fields.size() && f < earlier.fields.size(); ++f) {
    if (carried.fields[f].location != FieldLocation::kTriangle) continue;
    for (std::size_t t = 0; t < std::min(before.triangles.size(), after.triangles.size()); ++t) {
      if (before.triangles[t] == after.triangles[t]) carried.fields[f].values[t] = earlier.fields[f].values[t];
    }
  }
  return carried;
}

}  // namespace thinwall
