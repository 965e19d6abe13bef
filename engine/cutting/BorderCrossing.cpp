#include "engine/cutting/BorderCrossing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/cutting/SurfaceCurve.hpp"

namespace thinwall {
namespace {

/// Part of the way within which a border counts as one at its beginning.
constexpr double kAtBeginning = 1e-6;

/// Sine of the angle at which a blade meets a border at least when it comes back into the wall there.
constexpr double kLeastMeeting = 0.2588;

struct BorderSide {
  int triangle = 0, corner = 0;  // from this corner to the next
};

std::vector<BorderSide> border_sides(const SurfaceView& surface) {
  // The sides that start at each vertex, by their ends.
  std::vector<int> begin(static_cast<std::size_t>(surface.position.size() / 3) + 1, 0);
  for (const Eigen::Vector3i& t : surface.triangles) {
    for (const int vertex : t) ++begin[vertex + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<int> ends(begin.back()), next(begin.begin(), begin.end() - 1);
  for (const Eigen::Vector3i& t : surface.triangles) {
    for (int k = 0; k < 3; ++k) ends[next[t[k]]++] = t[(k + 1) % 3];
  }
  const auto has_side = [&](int from, int to) {
    return std::find(ends.begin() + begin[from], ends.begin() + begin[from + 1], to) != ends.begin() + begin[from + 1];
  };
  std::vector<BorderSide> sides;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Eigen::Vector3i& corners = surface.triangles[t];
    for (int k = 0; k < 3; ++k) {
      if (!has_side(corners[(k + 1) % 3], corners[k])) sides.push_back({static_cast<int>(t), k});
    }
  }
  return sides;
}

SurfacePoint point_on(const BorderSide& side, double part) {
  SurfacePoint point{.triangle = side.triangle, .weights = Eigen::Vector3d::Zero()};
  point.weights[side.corner] = 1 - part;
  point.weights[(side.corner + 1) % 3] = part;
  return point;
}

SurfacePoint nearest_on(const SurfaceView& surface, const BorderSide& side, const Eigen::Vector3d& point) {
  const Eigen::Vector3i& corners = surface.triangles[static_cast<std::size_t>(side.triangle)];
  const Eigen::Vector3d from = surface.position.segment<3>(3 * corners[side.corner]);
  const Eigen::Vector3d way = surface.position.segment<3>(3 * corners[(side.corner + 1) % 3]) - from;
  return point_on(side, std::clamp((point - from).dot(way) / way.squaredNorm(), 0.0, 1.0));
}

/// Where a border crosses the plane through a point, a unit way and a unit line across it.
struct SideCrossing {
  SurfacePoint place;
  double along = 0, height = 0;  // metres from the point, along the way and along the line
};

std::optional<SideCrossing> crossing_of(const SurfaceView& surface, const BorderSide& side, const Eigen::Vector3d& from,
                                        const Eigen::Vector3d& way, const Eigen::Vector3d& line) {
  const int next = (side.corner + 1) % 3;
  const Eigen::Vector3i& corners = surface.triangles[static_cast<std::size_t>(side.triangle)];
  const Eigen::Vector3d a = surface.position.segment<3>(3 * corners[side.corner]) - from;
  const Eigen::Vector3d b = surface.position.segment<3>(3 * corners[next]) - from;
  const Eigen::Vector3d aside = line.cross(way);
  const double off_a = a.dot(aside), off_b = b.dot(aside);
  if ((off_a > 0) == (off_b > 0)) return std::nullopt;
  const double part = off_a / (off_a - off_b);
  const Eigen::Vector3d place = a + part * (b - a);
  return SideCrossing{.place = point_on(side, part), .along = place.dot(way), .height = place.dot(line)};
}

/// Unit, from a border into its triangle, across the border.
Eigen::Vector3d into_wall(const SurfaceView& surface, const BorderSide& side) {
  const Eigen::Vector3i& corners = surface.triangles[static_cast<std::size_t>(side.triangle)];
  const auto at = [&](int k) -> Eigen::Vector3d { return surface.position.segment<3>(3 * corners[k % 3]); };
  const Eigen::Vector3d along = (at(side.corner + 1) - at(side.corner)).stableNormalized();
  const Eigen::Vector3d inwards = at(side.corner + 2) - at(side.corner);
  return (inwards - inwards.dot(along) * along).stableNormalized();
}

}  // namespace

std::optional<SurfacePoint> first_border(const SurfaceView& surface, const Eigen::Vector3d& from,
                                         const Eigen::Vector3d& to, const Eigen::Vector3d& line) {
  const Eigen::Vector3d chord = to - from, way = chord - chord.dot(line) * line;
  // Of lips that lie together the one that is come to has its wall behind it; a lip that is turned over need not.
  struct Nearest {
    std::optional<SurfacePoint> place = {};
    double along = std::numeric_limits<double>::infinity();
  };
  Nearest behind, any;
  for (const BorderSide& side : border_sides(surface)) {
    const std::optional<SideCrossing> crossing = crossing_of(surface, side, from, way.normalized(), line);
    if (!crossing || crossing->along <= kAtBeginning * way.norm() || crossing->along > way.norm()) continue;
    if (std::abs(crossing->height) > chord.norm()) continue;
    const bool is_behind = into_wall(surface, side).dot(way) < 0;
    if (crossing->along < any.along) any = {crossing->place, crossing->along};
    if (is_behind && crossing->along < behind.along) behind = {crossing->place, crossing->along};
  }
  return behind.place ? behind.place : any.place;
}

std::optional<SurfacePoint> border_beyond(const SurfaceView& surface, const BladeInGap& blade) {
  std::optional<SurfacePoint> found;
  double nearest = 0;
  const auto is_own = [&](int vertex) { return std::ranges::find(blade.lips, vertex) != blade.lips.end(); };
  for (const BorderSide& side : border_sides(surface)) {
    const Eigen::Vector3i& corners = surface.triangles[static_cast<std::size_t>(side.triangle)];
    if (is_own(corners[side.corner]) || is_own(corners[(side.corner + 1) % 3])) continue;
    const std::optional<SideCrossing> crossing = crossing_of(surface, side, blade.left, blade.way, blade.line);
    if (!crossing || crossing->along < -blade.overlap || into_wall(surface, side).dot(blade.way) < kLeastMeeting) {
      continue;
    }
    if (crossing->height < blade.above || crossing->height > blade.below) continue;
    if (found && std::abs(crossing->along) >= nearest) continue;
    nearest = std::abs(crossing->along);
    found = crossing->place;
  }
  return found;
}

std::optional<SurfacePoint> nearest_on_border(const SurfaceView& surface, const Eigen::Vector3d& point) {
  std::optional<SurfacePoint> place;
  double nearest = std::numeric_limits<double>::infinity();
  for (const BorderSide& side : border_sides(surface)) {
    const SurfacePoint candidate = nearest_on(surface, side, point);
    const double distance = (position_of(surface, candidate) - point).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    place = candidate;
  }
  return place;
}

std::vector<SurfacePoint> borders_around(const SurfaceView& surface, const Eigen::Vector3d& point, double reach) {
  std::vector<SurfacePoint> places;
  for (const BorderSide& side : border_sides(surface)) {
    const SurfacePoint place = nearest_on(surface, side, point);
    if ((position_of(surface, place) - point).norm() <= reach) places.push_back(place);
  }
  return places;
}

double distance_from_border(const SurfaceView& surface, const Eigen::Vector3d& point) {
  const std::optional<SurfacePoint> nearest = nearest_on_border(surface, point);
  return nearest ? (position_of(surface, *nearest) - point).norm() : std::numeric_limits<double>::infinity();
}

std::optional<SurfaceEntry> first_rim(const SurfaceView& surface, std::span<const double> thickness,
                                      const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  const auto across = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d { return v - v.dot(direction) * direction; };
  std::optional<SurfaceEntry> first;
  for (const BorderSide& side : border_sides(surface)) {
    const Eigen::Vector3i& corners = surface.triangles[static_cast<std::size_t>(side.triangle)];
    const int next = (side.corner + 1) % 3;
    const Eigen::Vector3d from = surface.position.segment<3>(3 * corners[side.corner]) - origin;
    const Eigen::Vector3d way = surface.position.segment<3>(3 * corners[next]) - origin - from;
    const double squared = across(way).squaredNorm();
    const double part = squared > 0 ? std::clamp(-across(from).dot(across(way)) / squared, 0.0, 1.0) : 0;
    const Eigen::Vector3d place = from + part * way;
    if (across(place).norm() > 0.5 * thickness[static_cast<std::size_t>(side.triangle)]) continue;
    if (first && place.dot(direction) >= first->travel) continue;
    first = {point_on(side, part), place.dot(direction)};
  }
  return first;
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
