#include "renderer/shape/CreaseShade.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/shape/ScreenArea.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {
namespace {

/// Multiple of the reach within which a vertex of the other wall tells where that is: walls are coarser than creases.
constexpr double kSpacing = 2.5;

double square(double value) {
  return value * value;
}

bool is_within(const Float3& position, const Bounds& bounds, double margin) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (position[k] < bounds.least[k] - margin || position[k] > bounds.most[k] + margin) return false;
  }
  return true;
}

/// Those of a wall within bounds, by their x.
std::vector<const SurfaceVertex*> candidates(std::span<const SurfaceVertex> wall, const Bounds& bounds, double margin) {
  std::vector<const SurfaceVertex*> found;
  for (const SurfaceVertex& vertex : wall) {
    if (is_within(vertex.position, bounds, margin)) found.push_back(&vertex);
  }
  std::ranges::stable_sort(found, {}, [](const SurfaceVertex* vertex) { return vertex->position[0]; });
  return found;
}

/// Metres from the tangent plane at the nearest of the candidates; the reach where none is near.
double distance_to(std::span<const SurfaceVertex* const> others, const Vector3& place, double reach) {
  double nearest = square(kSpacing * reach), distance = reach;  // metres^2, metres
  // Whether those farther along x may still be nearer.
  const auto look_at = [&](const SurfaceVertex& other) {
    const Vector3 apart = place - vector3(other.position);
    if (dot(apart, apart) < nearest) {
      nearest = dot(apart, apart);
      distance = std::abs(dot(apart, vector3(other.normal)));
    }
    return square(apart.x) < nearest;
  };
  const auto x_of = [](const SurfaceVertex* vertex) { return static_cast<double>(vertex->position[0]); };
  const auto begin = std::ranges::lower_bound(others, place.x, {}, x_of);
  for (auto next = begin; next != others.end() && look_at(**next); ++next) {
  }
  for (auto next = begin; next != others.begin() && look_at(**(next - 1)); --next) {
  }
  return distance;
}

void shade_beside(std::span<SurfaceVertex> wall, const Bounds& own, std::span<const SurfaceVertex> other,
                  const Bounds& theirs, const CreaseDefinition& crease) {
  const double margin = kSpacing * crease.reach;
  const std::vector<const SurfaceVertex*> others = candidates(other, own, margin);
  if (others.empty()) return;
  for (SurfaceVertex& vertex : wall) {
    if (!is_within(vertex.position, theirs, margin)) continue;
    const double near = 1 - distance_to(others, vector3(vertex.position), crease.reach) / crease.reach;
    if (near > 0) vertex.curvature = std::max(vertex.curvature, static_cast<float>(near * crease.curvature));
  }
}

}  // namespace

void shade_creases(std::span<const std::span<SurfaceVertex>> walls, const CreaseDefinition& crease) {
  std::vector<Bounds> bounds;
  for (const std::span<SurfaceVertex>& wall : walls) bounds.push_back(bounds_of(wall));
  for (std::size_t a = 0; a < walls.size(); ++a) {
    for (std::size_t b = 0; b < walls.size(); ++b) {
      if (a != b) shade_beside(walls[a], bounds[a], walls[b], bounds[b], crease);
    }
  }
}

}  // namespace thinwall
