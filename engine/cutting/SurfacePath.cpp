#include "engine/cutting/SurfacePath.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/contact/ClosestPoint.hpp"
#include "engine/cutting/SurfaceNormals.hpp"

namespace thinwall {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A line meets a triangle that it misses by this part of it only: no crack lets it through between two of them.
constexpr double kEdgeSlack = 1e-12;

/// Nearer than this to `point` no point of the triangle can be: its box tells, metres.
double least_distance(const Corners& corners, const Eigen::Vector3d& point) {
  const Eigen::Vector3d low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
  const Eigen::Vector3d high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  return (point - point.cwiseMax(low).cwiseMin(high)).norm();
}

SurfaceProjection nearest(const SurfaceView& surface, const Eigen::Vector3d& point) {
  SurfaceProjection best{.point = {}, .distance = kInfinity};
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const Corners corners = corners_of(surface, t);
    if (least_distance(corners, point) >= best.distance) continue;
    const SurfacePoint candidate{.triangle = t, .weights = closest_point(corners, point).weights};
    const double distance = (position_of(surface, candidate) - point).norm();
    if (distance < best.distance) best = {.point = candidate, .distance = distance};
  }
  return best;
}

SurfaceProjection nearest_along(const SurfaceView& surface, const Eigen::Vector3d& point,
                                const Eigen::Vector3d& direction) {
  SurfaceProjection best{.point = {}, .distance = kInfinity};
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const Corners corners = corners_of(surface, t);
    const Eigen::Vector3d a = corners[0] - point, b = corners[1] - point, c = corners[2] - point;
    // Signed volumes, as first_entry takes them: their sum is positive where the line meets the outer side.
    Eigen::Vector3d weights(-direction.dot(b.cross(c)), -direction.dot(c.cross(a)), -direction.dot(a.cross(b)));
    const double sum = weights.sum();
    if (!(surface.open ? sum != 0 : sum > 0)) continue;
    weights /= sum;
    if (weights.minCoeff() < -kEdgeSlack) continue;
    weights = weights.cwiseMax(0);
    const SurfacePoint candidate{.triangle = t, .weights = weights / weights.sum()};
    const double distance = std::abs((position_of(surface, candidate) - point).dot(direction));
    if (distance < best.distance) best = {.point = candidate, .distance = distance};
  }
  return best;
}

/// Adds the pieces of a trace to a path; the first goes on from the path's last one where they have a point in common.
void append(std::vector<SurfaceCurve>& pieces, std::vector<SurfaceCurve> more) {
  for (SurfaceCurve& next : more) {
    const SurfacePoint& first = next.points.front();
    const SurfacePoint* last = pieces.empty() ? nullptr : &pieces.back().points.back();
    if (last != nullptr && last->triangle == first.triangle && last->weights == first.weights) {
      SurfaceCurve& piece = pieces.back();
      piece.points.insert(piece.points.end(), next.points.begin() + 1, next.points.end());
      piece.triangles.insert(piece.triangles.end(), next.triangles.begin(), next.triangles.end());
    } else {
      pieces.push_back(std::move(next));
    }
  }
}

void add_stations(const SurfaceView& surface, const std::vector<Eigen::Vector3d>& normals, double side,
                  SurfacePath& path) {
  for (const SurfaceCurve& piece : path.pieces) {
    for (const SurfacePoint& point : piece.points) {
      PathStation station{.position = position_of(surface, point),
                          .inward = -side * smooth_normal(surface, normals, point)};
      const double step = path.stations.empty() ? 0 : (station.position - path.stations.back().position).norm();
      path.lengths.push_back(path.length() + step);
      path.stations.push_back(station);
    }
  }
}

}  // namespace

SurfaceProjection project(const SurfaceView& surface, const Eigen::Vector3d& point,
                          const std::optional<Eigen::Vector3d>& direction, double reach) {
  SurfaceProjection found = direction ? nearest_along(surface, point, *direction) : nearest(surface, point);
  if (found.distance > reach) found.point.reset();
  if (found.point) found.point = snapped_to_edges(surface, *found.point);
  return found;
}

PathStation SurfacePath::at(double along) const {
  const auto after = std::upper_bound(lengths.begin(), lengths.end(), along);
  if (after == lengths.begin()) return stations.front();
  if (after == lengths.end()) return stations.back();
  const auto next = static_cast<std::size_t>(after - lengths.begin());
  const PathStation &from = stations[next - 1], &to = stations[next];
  const double part = (along - lengths[next - 1]) / (lengths[next] - lengths[next - 1]);
  const Eigen::Vector3d inward = (1 - part) * from.inward + part * to.inward;
  return {.position = from.position + part * (to.position - from.position),
          .inward = inward.norm() > 0 ? inward.normalized() : from.inward};
}

PathResult surface_path(const SurfaceView& surface, std::span<const Eigen::Vector3d> points,
                        const std::optional<Eigen::Vector3d>& direction, double reach) {
  std::vector<SurfacePoint> brought;
  for (int k = 0; k < static_cast<int>(points.size()); ++k) {
    const SurfaceProjection found = project(surface, points[k], direction, reach);
    if (!found.point) {
      return {.path = {},
              .problem = PathProblem{.kind = PathProblem::Kind::kOffSurface, .point = k, .distance = found.distance}};
    }
    brought.push_back(*found.point);
  }
  if (brought.empty()) return {};
  bool from_behind = false;
  if (surface.open && direction) {
    const Eigen::Vector3d outward = smooth_normal(surface, brought.front());
    from_behind = outward.dot(*direction) > 0;
  }
  return path_through(surface, brought, from_behind);
}

PathResult path_through(const SurfaceView& surface, std::span<const SurfacePoint> points, bool from_behind) {
  PathResult result;
  if (points.empty()) return result;
  const std::vector<Eigen::Vector3d> normals = vertex_normals(surface);
  SurfacePath path;
  for (int k = 1; k < static_cast<int>(points.size()); ++k) {
    SurfaceTrace way = trace(surface, points[k - 1], points[k]);
    if (way.refusal != TraceRefusal::kNone) {
      const auto kind =
          way.refusal == TraceRefusal::kAlongNormal ? PathProblem::Kind::kAlongNormal : PathProblem::Kind::kNotJoined;
      return {.path = {}, .problem = PathProblem{.kind = kind, .point = k}};
    }
    append(path.pieces, std::move(way.pieces));
  }
  if (path.pieces.empty()) path.pieces = {{.points = {snapped_to_edges(surface, points[0])}, .triangles = {}}};
  add_stations(surface, normals, from_behind ? -1 : 1, path);
  result.path = std::move(path);
  return result;
}

}  // namespace thinwall
