#include "renderer/camera/SceneExtent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/snapshot/ActingSurfaces.hpp"
#include "renderer/snapshot/CutOutPieces.hpp"

namespace thinwall {
namespace {

bool is_finite(const Float3& point) {
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

void check_triangles(const std::string& body, const std::vector<Triangle>& triangles, std::size_t vertices) {
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t vertex : triangle) {
      if (vertex >= vertices) {
        throw PictureFailure("body '" + body + "' cannot be drawn: a triangle names vertex " + std::to_string(vertex) +
                             " of " + std::to_string(vertices) + "; the take is damaged");
      }
    }
  }
}

void check(const SnapshotSurface& surface) {
  const std::string cannot = "body '" + surface.body + "' cannot be drawn: ";
  if (!surface.topology) throw PictureFailure(cannot + "it has no triangles; the take is damaged");
  const std::size_t vertices = surface.topology->rest_positions.size();
  if (surface.positions.size() != vertices) {
    throw PictureFailure(cannot + std::to_string(surface.positions.size()) + " positions for " +
                         std::to_string(vertices) + " vertices; the take is damaged");
  }
  check_triangles(surface.body, surface.topology->triangles, vertices);
  check_triangles(surface.body, surface.topology->cap_triangles, vertices);
  const auto all_finite = [](const std::vector<Float3>& points) {
    return std::all_of(points.begin(), points.end(), is_finite);
  };
  if (!all_finite(surface.positions) || !all_finite(surface.topology->rest_positions)) {
    throw PictureFailure(cannot + "a position is not a finite number");
  }
}

/// The floor touches what stands on it; what is flat floats above it, so that it can be pressed down and casts a
/// shadow.
double floor_below(Vector3 low, Vector3 high, double lowest_now) {
  const double footprint = std::min(high.x - low.x, high.y - low.y);
  const double gap = std::max(0.0, 0.25 * footprint - (high.z - low.z));
  return std::min(low.z - gap, lowest_now);
}

/// Where the wall is now, but for what was cut out and falls.
std::vector<Vector3> standing_points(const SnapshotSurface& surface) {
  const std::vector<std::uint32_t> pieces = cut_out_pieces(*surface.topology);
  std::vector<Vector3> points;
  points.reserve(surface.positions.size());
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    if (pieces[v] == kHeldPiece) points.push_back(vector3(surface.positions[v]));
  }
  return points;
}

/// The floor does not go down with what was cut out and falls.
double lowest_of(std::span<const Vector3> points) {
  double lowest = std::numeric_limits<double>::max();
  for (const Vector3& point : points) lowest = std::min(lowest, point.z);
  return lowest;
}

bool is_outside(const Vector3& point, const Vector3& low, const Vector3& high) {
  return point.x < low.x || point.y < low.y || point.z < low.z || point.x > high.x || point.y > high.y ||
         point.z > high.z;
}

double lowest_at_rest(const SnapshotTopology& topology) {
  double lowest = std::numeric_limits<double>::max();
  for (const Float3& position : topology.rest_positions) lowest = std::min(lowest, static_cast<double>(position[2]));
  return lowest;
}

/// Below the ends of a sheet, at rest and now, by as much as it is thick.
double lowest_end(const SnapshotSurface& surface, std::span<const BorderEdge> ends) {
  const SnapshotTopology& topology = *surface.topology;
  double lowest = std::numeric_limits<double>::max();
  for (const BorderEdge& end : ends) {
    const double thickness = topology.thickness.empty() ? 0 : topology.thickness[end.triangle];
    const float height = std::min(topology.rest_positions[end.start][2], surface.positions[end.start][2]);
    lowest = std::min(lowest, static_cast<double>(height) - thickness);
  }
  return lowest;
}

/// Coarse steps keep the light's box, and with it the shadow's raster, still while the scene moves a little.
double round_up_coarsely(double reach, double base) {
  constexpr double kStep = 1.25;
  return base * std::pow(kStep, std::ceil(std::log(std::max(1.0, reach / base)) / std::log(kStep)));
}

WallSpread spread_of(std::span<const SnapshotSurface* const> surfaces, const Vector3& center) {
  WallSpread sum;
  double area = 0;
  for (const SnapshotSurface* surface : surfaces) {
    const std::vector<Float3>& rest = surface->topology->rest_positions;
    for (const auto& [i, j, k] : surface->topology->triangles) {
      const Vector3 a = vector3(rest[i]) - center, b = vector3(rest[j]) - center, c = vector3(rest[k]) - center;
      const double twice = length(cross(b - a, c - a));
      // The mean of a product over a triangle is that of its corners and of their sum, a twelfth of all four.
      for (const Vector3& at : {a, b, c, a + b + c}) {
        sum.xx += twice * at.x * at.x;
        sum.yy += twice * at.y * at.y;
        sum.zz += twice * at.z * at.z;
        sum.xy += twice * at.x * at.y;
        sum.yz += twice * at.y * at.z;
        sum.zx += twice * at.z * at.x;
      }
      area += 12 * twice;
    }
  }
  if (!(area > 0)) return {};
  for (double* one : {&sum.xx, &sum.yy, &sum.zz, &sum.xy, &sum.yz, &sum.zx}) *one /= area;
  return sum;
}

SceneExtent extent_of(std::span<const SnapshotSurface* const> surfaces) {
  constexpr double kFar = std::numeric_limits<double>::max();
  SceneExtent extent;
  Vector3 low{kFar, kFar, kFar};
  Vector3 high{-kFar, -kFar, -kFar};
  std::vector<Vector3> now;
  for (const SnapshotSurface* surface : surfaces) {
    for (const Float3& position : surface->topology->rest_positions) {
      const Vector3 point = vector3(position);
      extent.rest_points.push_back(point);
      low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
      high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
    }
    const std::vector<Vector3> standing = standing_points(*surface);
    now.insert(now.end(), standing.begin(), standing.end());
  }
  if (extent.rest_points.empty()) return extent;

  extent.center = 0.5 * (low + high);
  extent.spread = spread_of(surfaces, extent.center);
  extent.size = std::max(length(high - low), 1e-6);
  extent.floor_height = floor_below(low, high, lowest_of(now));
  for (const Vector3& point : now) {
    if (is_outside(point, low, high)) extent.grown_points.push_back(point);
  }
  double reach = 0;
  for (const SnapshotSurface* surface : surfaces) {
    for (const Float3& position : surface->positions)
      reach = std::max(reach, length(vector3(position) - extent.center));
  }
  extent.reach = round_up_coarsely(reach, 0.5 * extent.size);
  return extent;
}

}  // namespace

SceneExtent scene_extent(const Snapshot& snapshot) {
  std::vector<const SnapshotSurface*> all;
  for (const SnapshotSurface& surface : snapshot.surfaces) {
    check(surface);
    all.push_back(&surface);
  }
  SceneExtent extent = extent_of(all);
  const std::vector<const SnapshotSurface*> acting = acting_surfaces(snapshot);
  if (acting.size() < all.size()) extent.acting = std::make_shared<const SceneExtent>(extent_of(acting));
  return extent;
}

double lying_height(const Snapshot& snapshot, std::span<const std::vector<BorderEdge>> ends) {
  double lowest = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < snapshot.surfaces.size(); ++k) {
    const SnapshotSurface& surface = snapshot.surfaces[k];
    const double now = ends[k].empty() ? lowest_of(standing_points(surface)) : lowest_end(surface, ends[k]);
    lowest = std::min({lowest, now, lowest_at_rest(*surface.topology)});
  }
  return lowest;
}

}  // namespace thinwall
