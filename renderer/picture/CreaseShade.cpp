#include "renderer/picture/CreaseShade.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/picture/ScreenArea.hpp"
#include "renderer/picture/Vector.hpp"

namespace thinwall {
namespace {

/// Multiple of the reach within which a vertex of the other wall tells where that is: walls are coarser than creases.
constexpr double kSpacing = 2.5;

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
  const double radius = kSpacing * reach;
  const auto x_of = [](const SurfaceVertex* vertex) { return static_cast<double>(vertex->position[0]); };
  auto next = std::ranges::lower_bound(others, place.x - radius, {}, x_of);
  double nearest = radius, distance = reach;
  for (; next != others.end() && x_of(*next) <= place.x + radius; ++next) {
    const Vector3 apart = place - vector3((*next)->position);
    if (length(apart) >= nearest) continue;
    nearest = length(apart);
    distance = std::abs(dot(apart, vector3((*next)->normal)));
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
