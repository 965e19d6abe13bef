#include "renderer/shape/WithinBody.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/snapshot/Float3.hpp"

namespace thinwall {
namespace {

bool lies_between(const SnapshotSurface& surface, Vector3 place) {
  const std::array<double, 3> at{place.x, place.y, place.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [least, most] = std::ranges::minmax(surface.positions, {}, [&](const Float3& p) { return p[axis]; });
    if (!(at[axis] > least[axis] && at[axis] < most[axis])) return false;
  }
  return true;
}

/// The solid angle that a triangle fills around the origin, with a sign (Van Oosterom and Strackee 1983, equation 8).
double solid_angle(Vector3 a, Vector3 b, Vector3 c) {
  const double u = length(a), v = length(b), w = length(c);
  return 2 * std::atan2(dot(a, cross(b, c)), u * v * w + dot(a, b) * w + dot(b, c) * u + dot(c, a) * v);
}

}  // namespace

bool lies_within(const SnapshotSurface& surface, Vector3 place) {
  if (surface.positions.empty() || !lies_between(surface, place)) return false;
  double angle = 0;
  for (const auto* triangles : {&surface.topology->triangles, &surface.topology->cap_triangles}) {
    for (const Triangle& triangle : *triangles) {
      const auto corner = [&](std::size_t k) { return vector3(surface.positions[triangle[k]]) - place; };
      angle += solid_angle(corner(0), corner(1), corner(2));
    }
  }
  return std::abs(angle) > 2 * std::numbers::pi;
}

}  // namespace thinwall
