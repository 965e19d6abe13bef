#include "engine/cutting/BorderCrossing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace thinwall {
namespace {

/// Part of the way within which a border counts as one at its beginning.
constexpr double kAtBeginning = 1e-6;

struct BorderSide {
  int triangle = 0, corner = 0;  // from this corner to the next
};

std::vector<BorderSide> border_sides(const SurfaceView& surface) {
  std::vector<std::pair<int, int>> halves;
  for (const Eigen::Vector3i& t : surface.triangles) {
    for (int k = 0; k < 3; ++k) halves.emplace_back(t[k], t[(k + 1) % 3]);
  }
  std::ranges::sort(halves);
  std::vector<BorderSide> sides;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::pair<int, int> opposite(surface.triangles[t][(k + 1) % 3], surface.triangles[t][k]);
      if (!std::ranges::binary_search(halves, opposite)) sides.push_back({static_cast<int>(t), k});
    }
  }
  return sides;
}

}  // namespace

std::optional<SurfacePoint> border_crossing(const SurfaceView& surface, const Eigen::Vector3d& from,
                                            const Eigen::Vector3d& to, const Eigen::Vector3d& line, Crossing which) {
  const Eigen::Vector3d way = to - from - (to - from).dot(line) * line;
  const Eigen::Vector3d aside = line.cross(way);
  std::optional<SurfacePoint> found;
  double best = 0;
  for (const BorderSide& side : border_sides(surface)) {
    const int next = (side.corner + 1) % 3;
    const Eigen::Vector3i& corners = surface.triangles[static_cast<std::size_t>(side.triangle)];
    const Eigen::Vector3d a = surface.position.segment<3>(3 * corners[side.corner]) - from;
    const Eigen::Vector3d b = surface.position.segment<3>(3 * corners[next]) - from;
    const double off_a = a.dot(aside), off_b = b.dot(aside);
    if ((off_a > 0) == (off_b > 0)) continue;
    const double part = off_a / (off_a - off_b);
    const Eigen::Vector3d place = a + part * (b - a);
    const double along = place.dot(way) / way.squaredNorm();
    if (along <= kAtBeginning || along > 1 || std::abs(place.dot(line)) > (to - from).norm()) continue;
    if (found && (which == Crossing::kFirst ? along >= best : along <= best)) continue;
    best = along;
    found = SurfacePoint{.triangle = side.triangle};
    found->weights[side.corner] = 1 - part;
    found->weights[next] = part;
  }
  return found;
}

Eigen::Vector3d way_ahead(const SurfaceView& surface, int tip) {
  Eigen::Vector3d ahead = Eigen::Vector3d::Zero();
  for (const BorderSide& side : border_sides(surface)) {
    const Eigen::Vector3i& corners = surface.triangles[static_cast<std::size_t>(side.triangle)];
    const int start = corners[side.corner], end = corners[(side.corner + 1) % 3];
    if (start != tip && end != tip) continue;
    const int other = start == tip ? end : start;
    ahead += (surface.position.segment<3>(3 * tip) - surface.position.segment<3>(3 * other)).normalized();
  }
  return ahead;
}

}  // namespace thinwall
