#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/cutting/CutSurface.hpp"

namespace thinwall {

inline Eigen::Vector3d position_of(const SurfaceMesh& mesh, const SurfacePoint& point) {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) position += point.weights[k] * mesh.vertices[mesh.triangles[point.triangle][k]];
  return position;
}

/// The same point in the triangle that a direction leads into, where it is a vertex.
inline SurfacePoint turned_towards(const CutSurface& surface, const SurfacePoint& point,
                                   const Eigen::Vector3d& direction) {
  const SurfaceMesh& mesh = surface.mesh();
  int corner = 0;
  if (point.weights.maxCoeff(&corner) < 1) return point;
  const int vertex = mesh.triangles[point.triangle][corner];
  SurfacePoint best = point;
  double best_depth = -10;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (mesh.triangles[t][k] != vertex) continue;
      const Eigen::Vector3d& at = mesh.vertices[vertex];
      const Eigen::Vector3d a = mesh.vertices[mesh.triangles[t][(k + 1) % 3]] - at;
      const Eigen::Vector3d b = mesh.vertices[mesh.triangles[t][(k + 2) % 3]] - at;
      const Eigen::Vector3d normal = a.cross(b).normalized();
      const double depth =
          std::min(normal.dot(a.normalized().cross(direction)), normal.dot(direction.cross(b.normalized())));
      if (depth <= best_depth) continue;
      best_depth = depth;
      best = {.triangle = static_cast<int>(t), .weights = Eigen::Vector3d::Unit(k)};
    }
  }
  return best;
}

/// A walk straight ahead over a surface (a geodesic: the direction is unfolded over each edge), from a point over
/// `length` metres or to an open border. Points: the start, one on each edge crossed, the end.
struct SurfaceWalk {
  std::vector<SurfacePoint> points;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // at the end
  double length = 0;                                    // metres
  bool at_border = false;
};

/// How fast each weight falls along a direction in the plane of a triangle, 1 / metre. `normal`: of twice its area.
inline Eigen::Vector3d weight_rates(const SurfaceMesh& mesh, const Eigen::Vector3i& corners,
                                    const Eigen::Vector3d& normal, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d &a = mesh.vertices[corners[0]], &b = mesh.vertices[corners[1]], &c = mesh.vertices[corners[2]];
  const double twice = normal.norm();
  const Eigen::Vector3d unit = normal / twice;
  return {unit.cross(c - b).dot(direction) / twice, unit.cross(a - c).dot(direction) / twice,
          unit.cross(b - a).dot(direction) / twice};
}

/// A direction unfolded over the edge from corner k of a triangle to the next one, into another triangle that has the
/// edge's end as its corner `corner`.
inline Eigen::Vector3d unfolded(const SurfaceMesh& mesh, const Eigen::Vector3i& corners, int k,
                                const Eigen::Vector3i& others, int corner, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d from = mesh.vertices[corners[k]], to = mesh.vertices[corners[(k + 1) % 3]];
  const Eigen::Vector3d edge = (to - from).normalized();
  Eigen::Vector3d across = mesh.vertices[others[(corner + 2) % 3]] - to;
  across = (across - across.dot(edge) * edge).normalized();
  const double along = direction.dot(edge);
  return along * edge + std::sqrt(std::max(0.0, 1 - along * along)) * across;
}

/// The side that a way meets within `reach`, by the rates of its weights, and not the one that it came by; -1 where it
/// meets none. `reach` becomes the way there.
inline int side_ahead(const Eigen::Vector3d& weights, const Eigen::Vector3d& rate, int entered, double& reach) {
  int through = -1;
  for (int k = 0; k < 3; ++k) {
    const int side = (k + 1) % 3;  // opposite corner k
    if (rate[k] >= 0 || side == entered) continue;
    const double to_side = std::max(0.0, -weights[k] / rate[k]);
    if (to_side > reach) continue;
    reach = to_side;
    through = side;
  }
  return through;
}

inline SurfaceWalk walk_on(const CutSurface& surface, SurfacePoint start, Eigen::Vector3d direction, double length) {
  const SurfaceMesh& mesh = surface.mesh();
  SurfaceWalk walk;
  start = turned_towards(surface, start, direction);
  walk.points.push_back(start);
  int t = start.triangle, entered = -1;
  Eigen::Vector3d weights = start.weights;
  for (int steps = 0; steps < 100000 && walk.length < length; ++steps) {
    const Eigen::Vector3i& corners = mesh.triangles[t];
    const Eigen::Vector3d &a = mesh.vertices[corners[0]], &b = mesh.vertices[corners[1]],
                          &c = mesh.vertices[corners[2]];
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    direction = (direction - direction.dot(normal) / normal.squaredNorm() * normal).normalized();
    const Eigen::Vector3d rate = weight_rates(mesh, corners, normal, direction);
    double reach = length - walk.length;
    const int through = side_ahead(weights, rate, entered, reach);
    weights += reach * rate;
    walk.length += reach;
    if (through < 0) {
      weights = weights.cwiseMax(0.0);
      walk.points.push_back({.triangle = t, .weights = weights / weights.sum()});
      break;
    }
    weights[(through + 2) % 3] = 0;
    constexpr double kFromVertex = 1e-7;  // the walk keeps off vertices, where "straight ahead" has no one meaning
    for (const int k : {through, (through + 1) % 3}) weights[k] = std::max(weights[k], kFromVertex);
    weights /= weights.sum();
    walk.points.push_back({.triangle = t, .weights = weights});
    const int next = surface.neighbours()[t][through];
    if (next < 0) {
      walk.at_border = true;
      break;
    }
    const Eigen::Vector3i& others = mesh.triangles[next];
    const int corner = static_cast<int>(std::ranges::find(others, corners[(through + 1) % 3]) - others.begin());
    direction = unfolded(mesh, corners, through, others, corner, direction);
    Eigen::Vector3d carried = Eigen::Vector3d::Zero();
    carried[corner] = weights[(through + 1) % 3];
    carried[(corner + 1) % 3] = weights[through];
    weights = carried;
    entered = corner;
    t = next;
  }
  walk.direction = direction;
  return walk;
}

}  // namespace thinwall
