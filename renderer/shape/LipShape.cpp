#include "renderer/shape/LipShape.hpp"

#include <algorithm>
#include <limits>

namespace thinwall {
namespace {

/// Rows of triangles beside a lip over which the way through the wall is evened.
constexpr int kRows = 3;

/// (vertices), rows of triangles to the nearest lip, kRows and more away kRows.
std::vector<int> rows_from_lip(std::span<const char> is_lip, const std::vector<Triangle>& triangles) {
  std::vector<int> rows(is_lip.size(), kRows);
  for (std::size_t v = 0; v < is_lip.size(); ++v) {
    if (is_lip[v]) rows[v] = 0;
  }
  for (int row = 1; row < kRows; ++row) {
    for (const Triangle& triangle : triangles) {
      const bool touches = std::ranges::any_of(triangle, [&](std::uint32_t v) { return rows[v] == row - 1; });
      if (!touches) continue;
      for (const std::uint32_t v : triangle) rows[v] = std::min(rows[v], row);
    }
  }
  return rows;
}

void even_ways(const std::vector<int>& rows, const std::vector<Triangle>& triangles, std::vector<Vector3>& ways) {
  for (int turn = 0; turn < 2 * kRows; ++turn) {
    std::vector<Vector3> sums(ways.size());
    std::vector<int> counts(ways.size(), 0);
    for (const Triangle& triangle : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = triangle[k];
        if (rows[v] >= kRows) continue;
        sums[v] = sums[v] + ways[triangle[(k + 1) % 3]] + ways[triangle[(k + 2) % 3]];
        counts[v] += 2;
      }
    }
    for (std::size_t v = 0; v < ways.size(); ++v) {
      if (counts[v] > 0) ways[v] = normalized(ways[v] + (1.0 / counts[v]) * sums[v], ways[v]);
    }
  }
}

Vector3 nearest_on(Vector3 place, Vector3 a, Vector3 b) {
  const Vector3 along = b - a;
  const double squared = dot(along, along);
  const double part = squared > 0 ? std::clamp(dot(place - a, along) / squared, 0.0, 1.0) : 0;
  return a + part * along;
}

struct Lip {
  BorderEdge edge;
  Vector3 start, end;
  Vector3 forward;  // out of the wall
};

/// Half of how far a lip's vertex can go before it meets the other lip; where they lie over each other, nothing.
double room_at(std::uint32_t vertex, Vector3 place, Vector3 forward, std::span<const Lip> lips) {
  double nearest = std::numeric_limits<double>::infinity(), ahead = 0;
  for (const Lip& lip : lips) {
    if (lip.edge.start == vertex || lip.edge.end == vertex || dot(lip.forward, forward) >= 0) continue;
    const Vector3 way = nearest_on(place, lip.start, lip.end) - place;
    if (dot(way, way) >= nearest) continue;
    nearest = dot(way, way);
    ahead = dot(way, forward);
  }
  return 0.5 * std::max(0.0, ahead);
}

}  // namespace

LipShape lip_shape(const SnapshotSurface& surface, std::span<const SurfaceVertex> wall,
                   std::span<const BorderEdge> borders) {
  LipShape shape;
  for (const SurfaceVertex& vertex : wall) shape.through.push_back(-vector3(vertex.normal));
  shape.forward.assign(wall.size(), {});
  shape.room.assign(wall.size(), 0);
  shape.next.assign(wall.size(), LipShape::kNoLip);
  const std::vector<char> is_lip = cut_lips(*surface.topology, borders);
  if (std::ranges::none_of(is_lip, [](char lip) { return lip != 0; })) return shape;
  const std::vector<Triangle>& triangles = surface.topology->triangles;
  even_ways(rows_from_lip(is_lip, triangles), triangles, shape.through);

  std::vector<Lip> lips;
  for (const BorderEdge& edge : borders) {
    if (!is_lip[edge.start] || !is_lip[edge.end]) continue;
    const Vector3 start = vector3(surface.positions[edge.start]), end = vector3(surface.positions[edge.end]);
    const Vector3 inwards = shape.through[edge.start] + shape.through[edge.end];
    const Vector3 forward = normalized(cross(inwards, end - start), {0, 0, 0});
    lips.push_back({.edge = edge, .start = start, .end = end, .forward = forward});
    shape.next[edge.start] = edge.end;
    for (const std::uint32_t v : {edge.start, edge.end}) shape.forward[v] = shape.forward[v] + forward;
  }
  for (std::uint32_t v = 0; v < wall.size(); ++v) {
    if (!is_lip[v]) continue;
    const Vector3 out = shape.forward[v] - dot(shape.forward[v], shape.through[v]) * shape.through[v];
    shape.forward[v] = normalized(out, {0, 0, 0});
    shape.room[v] = room_at(v, vector3(surface.positions[v]), shape.forward[v], lips);
  }
  return shape;
}

void even_along_lips(const LipShape& lips, int turns, std::vector<double>& values) {
  for (int turn = 0; turn < turns; ++turn) {
    std::vector<double> sums(values.size(), 0);
    std::vector<int> counts(values.size(), 0);
    for (std::size_t v = 0; v < values.size(); ++v) {
      const std::uint32_t next = lips.next[v];
      if (next == LipShape::kNoLip) continue;
      sums[v] += values[next];
      sums[next] += values[v];
      ++counts[v];
      ++counts[next];
    }
    for (std::size_t v = 0; v < values.size(); ++v) {
      if (counts[v] > 0) values[v] = 0.5 * (values[v] + sums[v] / counts[v]);
    }
  }
}

}  // namespace thinwall
