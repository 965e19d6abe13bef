#include "engine/cutting/CutBooks.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <set>

namespace thinwall {
namespace {

SurfacePoint without_rounding(SurfacePoint point, double no_weight) {
  for (double& weight : point.weights) weight = weight < no_weight ? 0 : weight;
  point.weights /= point.weights.sum();
  return point;
}

SurfacePoint point_in(const CutPatch& patch, int facet, const Eigen::Vector3d& position, double no_weight) {
  const auto [triangle, weights] = patch.locate(facet, position);
  return without_rounding({.triangle = triangle, .weights = weights}, no_weight);
}

/// The triangles before, on the facet of the vertex, that the triangles around it now come from.
std::set<int> sources_around(const CutPatch& after, int vertex, std::span<const TriangleSource> triangles) {
  const int facet = after.facet[after.vertex_triangle[vertex]];
  std::set<int> around;
  for (const PatchCorner& corner : after.fan_of(vertex).corners) {
    if (after.facet[corner.triangle] != facet) continue;
    const auto found = std::ranges::lower_bound(triangles, corner.triangle, {}, &TriangleSource::triangle);
    if (found == triangles.end() || found->triangle != corner.triangle) {
      around.insert(corner.triangle);  // it has not changed
      continue;
    }
    for (const TriangleShare& share : found->before) around.insert(share.triangle);
  }
  return around;
}

/// The one of some triangles that has a position, by its least weight.
SurfacePoint nearest_of(const CutPatch& patch, const std::set<int>& triangles, const Eigen::Vector3d& position) {
  SurfacePoint nearest{.triangle = -1, .weights = Eigen::Vector3d::Zero()};
  double least = -std::numeric_limits<double>::infinity();
  for (const int triangle : triangles) {
    const Eigen::Vector3d weights = patch.barycentric(triangle, position);
    if (!(weights.minCoeff() > least)) continue;
    least = weights.minCoeff();
    nearest = {.triangle = triangle, .weights = weights};
  }
  return nearest;
}

}  // namespace

std::vector<SurfacePoint> rest_of(std::span<const PathStop> stops, const PlannedCut& plan) {
  constexpr double kNoWeight = 1e-9;
  std::vector<SurfacePoint> rest;
  for (const Eigen::Vector3d& corner : corners_ahead(stops, plan)) {
    rest.push_back(point_in(plan.patch, stops[plan.reached_stop].facet, corner, kNoWeight));
  }
  return rest;
}

std::vector<VertexSource> vertex_sources(const CutPatch& before, const CutPatch& after,
                                         std::span<const TriangleSource> triangles, std::span<const int> originals) {
  constexpr double kNoWeight = 1e-12;
  const int old = before.vertex_count(), splits_end = after.vertex_count() - static_cast<int>(originals.size());
  const auto source = [&](int vertex) {
    const std::set<int> around = sources_around(after, vertex, triangles);
    return VertexSource{.vertex = vertex,
                        .before = without_rounding(nearest_of(before, around, after.positions[vertex]), kNoWeight)};
  };
  std::vector<VertexSource> sources;
  for (int v = old; v < after.vertex_count(); ++v) {
    sources.push_back(source(v));
    if (v >= splits_end) sources.back().original = originals[v - splits_end];
  }
  for (int v = 0; v < old; ++v) {
    if (before.positions[v] != after.positions[v]) sources.push_back(source(v));
  }
  return sources;
}

std::vector<std::vector<int>> split_borders(const CutPatch& before, const CutPatch& after) {
  std::vector<std::vector<int>> chains;
  for (int t = 0; t < before.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (before.frozen[t] || !CutPatch::is_open(before.neighbours[t][k])) continue;
      const int from = before.triangles[t][k], to = before.triangles[t][(k + 1) % 3];
      if (after.side_between(from, to).triangle >= 0) continue;
      std::vector<int> chain = {from};
      while (chain.back() != to) {
        const PatchCorner first = after.fan_of(chain.back()).corners.front();
        chain.push_back(after.triangles[first.triangle][(first.corner + 1) % 3]);
      }
      chains.push_back(std::move(chain));
    }
  }
  return chains;
}

std::optional<int> tip_of(const PlannedCut& plan) {
  const PatchFan fan = plan.patch.fan_of(plan.vertices.back());
  int marks = 0;
  for (const PatchCorner& corner : fan.corners) marks += plan.patch.on_path[corner.triangle][corner.corner] != 0;
  return fan.closed && marks == 1 ? std::optional(plan.vertices.back()) : std::nullopt;
}

void count_changes(const CutPatch& before, const CutPatch& after, Cut& result) {
  // Volumes are taken about a point of the patch, which keeps digits far from the origin.
  const Eigen::Vector3d& origin = before.positions.front();
  const auto measure = [&](const CutPatch& patch, int t, double sign) {
    const Eigen::Vector3d a = patch.positions[patch.triangles[t][0]] - origin,
                          b = patch.positions[patch.triangles[t][1]] - origin,
                          c = patch.positions[patch.triangles[t][2]] - origin;
    result.counts.area_change += sign * 0.5 * (b - a).cross(c - a).norm();
    result.counts.volume_change += sign * a.dot(b.cross(c)) / 6;
  };
  for (int t = 0; t < before.triangle_count(); ++t) {
    if (after.changed[t]) measure(before, t, -1);
  }
  for (int t = 0; t < after.triangle_count(); ++t) {
    if (after.changed[t]) measure(after, t, 1);
  }
  for (int v = 0; v < before.vertex_count(); ++v) {
    result.counts.moved_vertices += before.positions[v] != after.positions[v];
  }
  const auto borders = [](const CutPatch& patch) {
    int count = 0;
    for (const Eigen::Vector3i& around : patch.neighbours) {
      count += static_cast<int>(std::ranges::count_if(around, CutPatch::is_open));
    }
    return count;
  };
  const int vertices = after.vertex_count() - before.vertex_count();
  const int triangles = after.triangle_count() - before.triangle_count();
  const int half_edges = 3 * triangles + borders(after) - borders(before);  // two for each edge
  result.euler_change = vertices - half_edges / 2 + triangles;
}

}  // namespace thinwall
