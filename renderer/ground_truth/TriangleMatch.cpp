#include "renderer/ground_truth/TriangleMatch.hpp"

#include <algorithm>
#include <limits>

namespace thinwall {
namespace {

/// Cutting may leave the surface by this part of a triangle's size where it is curved.
constexpr double kSameSurface = 0.1;

std::array<Vector3, 3> corners_of(const RestSurface& surface, std::uint32_t triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  return {vector3(surface.positions[a]), vector3(surface.positions[b]), vector3(surface.positions[c])};
}

bool is_same_triangle(const RestSurface& from, const RestSurface& to, std::uint32_t triangle) {
  if (triangle >= from.triangles.size() || triangle >= to.triangles.size()) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (from.positions[from.triangles[triangle][k]] != to.positions[to.triangles[triangle][k]]) return false;
  }
  return true;
}

}  // namespace

std::pair<std::array<double, 3>, double> nearest_weights(Vector3 point, const std::array<Vector3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vector3 ab = b - a, ac = c - a;
  const double d1 = dot(ab, point - a), d2 = dot(ac, point - a);
  const double d3 = dot(ab, point - b), d4 = dot(ac, point - b);
  const double d5 = dot(ab, point - c), d6 = dot(ac, point - c);
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  std::array<double, 3> weights;
  if (d1 <= 0 && d2 <= 0) {
    weights = {1, 0, 0};
  } else if (d3 >= 0 && d4 <= d3) {
    weights = {0, 1, 0};
  } else if (d6 >= 0 && d5 <= d6) {
    weights = {0, 0, 1};
  } else if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    weights = {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  } else if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    weights = {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  } else if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double along = (d4 - d3) / (d4 - d3 + d5 - d6);
    weights = {0, 1 - along, along};
  } else {
    const double sum = va + vb + vc;
    weights = {1 - vb / sum - vc / sum, vb / sum, vc / sum};
  }
  return {weights, length(weights[0] * a + weights[1] * b + weights[2] * c - point)};
}

TriangleMatch::TriangleMatch(const RestSurface& from, const RestSurface& to) : from_(from), to_(to) {
  for (std::uint32_t t = 0; t < from.triangles.size(); ++t) is_same_.push_back(is_same_triangle(from, to, t));
  for (std::uint32_t t = 0; t < to.triangles.size(); ++t) {
    if (!is_same_triangle(from, to, t)) changed_.push_back(t);
  }
}

std::optional<SurfacePlace> TriangleMatch::find(const SurfacePlace& place) const {
  if (is_same_[place.triangle]) return place;
  const std::array<Vector3, 3> corners = corners_of(from_, place.triangle);
  const Vector3 point = place.weights[0] * corners[0] + place.weights[1] * corners[1] + place.weights[2] * corners[2];
  std::optional<SurfacePlace> found;
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint32_t t : changed_) {
    const std::array<Vector3, 3> other = corners_of(to_, t);
    const double size = std::max(length(other[1] - other[0]), length(other[2] - other[0]));
    if (length(point - other[0]) > size + nearest) continue;
    const auto [weights, distance] = nearest_weights(point, other);
    if (distance > kSameSurface * size || distance >= nearest) continue;
    nearest = distance;
    found = {.triangle = t, .weights = weights};
  }
  return found;
}

}  // namespace thinwall
