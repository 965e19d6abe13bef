#include "renderer/shape/WallThickness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "renderer/shape/LipShape.hpp"
#include "renderer/shape/WallRoom.hpp"
#include "renderer/snapshot/Float3.hpp"
#include "renderer/snapshot/Vector.hpp"
#include "renderer/wound/RestNormals.hpp"

namespace thinwall {
namespace {

constexpr double kSmoothCosine = 0.5;

/// Thickness over that at rest that a wall grows to at most: one that is crushed further wrinkles instead.
constexpr double kThickest = 1.5;

double area_of(const Triangle& triangle, const std::vector<Float3>& positions) {
  const Vector3 a = vector3(positions[triangle[0]]);
  return 0.5 * length(cross(vector3(positions[triangle[1]]) - a, vector3(positions[triangle[2]]) - a));
}

/// (vertices), metres, of the wall as it is now: the volume of the tissue around over the area there.
std::vector<double> thickness_now(const SnapshotSurface& surface) {
  const SnapshotTopology& topology = *surface.topology;
  std::vector<double> volume(surface.positions.size(), 0), area = volume, rest_area = volume;
  for (std::size_t t = 0; t < topology.triangles.size(); ++t) {
    const double rest = area_of(topology.triangles[t], topology.rest_positions);
    const double now = area_of(topology.triangles[t], surface.positions);
    for (const std::uint32_t vertex : topology.triangles[t]) {
      volume[vertex] += topology.thickness[t] * rest;
      rest_area[vertex] += rest;
      area[vertex] += now;
    }
  }
  std::vector<double> thickness(volume.size(), 0);
  for (std::size_t v = 0; v < volume.size(); ++v) {
    const double least_area = std::max(area[v], rest_area[v] / kThickest);
    if (least_area > 0) thickness[v] = volume[v] / least_area;
  }
  return thickness;
}

/// A wall of thickness t around a hole with a way of length L around it is drawn no thicker there than this times
/// L^2/t, and as much thicker beside it as it is away: what lies deep in a hole that is small beside the thickness is
/// not seen, but its sides, which a needle turns up, would stand out.
constexpr double kHoleDepth = 0.05;

/// Length of the border that each vertex is on, metres; 0 off all borders. (vertices)
std::vector<double> border_lengths(const SnapshotSurface& surface, std::span<const BorderEdge> borders) {
  constexpr std::uint32_t kNone = 0xffffffff;
  std::vector<std::uint32_t> next(surface.positions.size(), kNone);
  for (const BorderEdge& edge : borders) next[edge.start] = edge.end;
  std::vector<double> lengths(surface.positions.size(), 0);
  std::vector<char> is_done(surface.positions.size(), 0);
  for (const BorderEdge& first : borders) {
    double whole = 0;
    std::vector<std::uint32_t> loop;
    for (std::uint32_t v = first.start; v != kNone && !is_done[v]; v = next[v]) {
      is_done[v] = 1;
      loop.push_back(v);
      if (next[v] == kNone) continue;
      whole += length(vector3(surface.positions[next[v]]) - vector3(surface.positions[v]));
    }
    for (const std::uint32_t v : loop) lengths[v] = whole;
  }
  return lengths;
}

/// `thickness`: (vertices), metres.
void thin_around_holes(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                       std::vector<double>& thickness) {
  const std::vector<double> lengths = border_lengths(surface, borders);
  for (std::size_t v = 0; v < thickness.size(); ++v) {
    if (lengths[v] == 0 || thickness[v] == 0) continue;
    thickness[v] = std::min(thickness[v], kHoleDepth * lengths[v] * lengths[v] / thickness[v]);
  }
  for (bool changes = true; changes;) {
    changes = false;
    for (const Triangle& triangle : surface.topology->triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
        const double away = length(vector3(surface.positions[b]) - vector3(surface.positions[a]));
        for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
          if (thickness[to] <= thickness[from] + away * (1 + 1e-12)) continue;
          thickness[to] = thickness[from] + away;
          changes = true;
        }
      }
    }
  }
}

/// How often a wall that turns too sharply for its thickness is drawn half as thick where it does.
constexpr int kThinnings = 6;

/// Makes the wall thin where its inner side would be turned over: its thickness is more there than the radius of its
/// bend. `thickness`: (vertices), metres.
void thin_sharp_bends(const SnapshotSurface& surface, const LipShape& lips, std::vector<double>& thickness) {
  const auto inner = [&](std::uint32_t vertex) {
    return vector3(surface.positions[vertex]) + thickness[vertex] * lips.through[vertex];
  };
  for (int turn = 0; turn < kThinnings; ++turn) {
    std::vector<char> is_bent(thickness.size(), 0);
    for (const Triangle& triangle : surface.topology->triangles) {
      const Vector3 a = vector3(surface.positions[triangle[0]]), lining = inner(triangle[0]);
      const Vector3 outwards =
          cross(vector3(surface.positions[triangle[1]]) - a, vector3(surface.positions[triangle[2]]) - a);
      if (dot(cross(inner(triangle[1]) - lining, inner(triangle[2]) - lining), outwards) > 0) continue;
      for (const std::uint32_t vertex : triangle) is_bent[vertex] = 1;
    }
    for (std::size_t v = 0; v < thickness.size(); ++v) {
      if (is_bent[v]) thickness[v] *= 0.5;
    }
  }
}

/// Directions out of the wall along each border edge, of length one, (borders).
std::vector<Vector3> outward_directions(const SnapshotSurface& surface, std::span<const SurfaceVertex> wall,
                                        std::span<const BorderEdge> borders) {
  std::vector<Vector3> directions;
  for (const BorderEdge& edge : borders) {
    const Vector3 along = vector3(surface.positions[edge.end]) - vector3(surface.positions[edge.start]);
    const Vector3 normal = vector3(wall[edge.start].normal) + vector3(wall[edge.end].normal);
    directions.push_back(normalized(cross(along, normal), normalized(along)));
  }
  return directions;
}

/// Part of its thickness by which a cut wall's inner side stands forward into the wound at most, for the outer one is
/// drawn back: so both faces of a cut are seen from outside. What of the room before it the inner side takes.
constexpr double kMostLean = 0.45;
constexpr double kTakenRoom = 0.8;

/// How often the depth of a rim is evened along the lip.
constexpr int kEvenings = 3;

/// (vertices), sines of the angle by which the way through a cut wall leans into the wound.
std::vector<double> lean_of(const LipShape& lips, std::span<const double> thickness) {
  std::vector<double> lean(thickness.size(), 0);
  for (std::size_t v = 0; v < lean.size(); ++v) {
    if (thickness[v] > 0) lean[v] = std::min(kMostLean, kTakenRoom * lips.room[v] / thickness[v]);
  }
  even_along_lips(lips, kEvenings, lean);
  return lean;
}

/// Of the inner side, which lies `through` (metres) from the outer one.
SurfaceVertex inner_vertex(SurfaceVertex vertex, Vector3 through) {
  vertex.position = float3(vector3(vertex.position) + through);
  vertex.normal = float3(-vector3(vertex.normal));
  vertex.curvature = -vertex.curvature;
  return vertex;
}

}  // namespace

WallWays wall_ways(const SnapshotSurface& surface, std::span<const SurfaceVertex> wall,
                   std::span<const BorderEdge> borders) {
  if (borders.empty() || surface.topology->thickness.size() != surface.topology->triangles.size()) return {};
  std::vector<double> thickness = thickness_now(surface);
  std::vector<double> with_room = thickness;
  thin_to_room(surface, wall, with_room);
  thin_around_holes(surface, borders, thickness);
  LipShape lips = lip_shape(surface, wall, borders);
  thin_sharp_bends(surface, lips, thickness);
  std::ranges::transform(thickness, with_room, thickness.begin(), std::ranges::min);
  even_along_lips(lips, kEvenings, thickness);
  std::vector<double> lean = lean_of(lips, thickness);
  return {.thickness = std::move(thickness),
          .lean = std::move(lean),
          .through = std::move(lips.through),
          .forward = std::move(lips.forward)};
}

WallDepth wall_depth(const SnapshotSurface& surface, std::span<const SurfaceVertex> wall,
                     std::span<const BorderEdge> borders, const WallWays& ways) {
  WallDepth depth;
  if (ways.thickness.empty()) return depth;
  const auto& [thickness, lean, way_through, forward] = ways;
  for (std::size_t v = 0; v < wall.size(); ++v) {
    const Vector3 through = std::sqrt(1 - lean[v] * lean[v]) * way_through[v] + lean[v] * forward[v];
    depth.lining.push_back(inner_vertex(wall[v], thickness[v] * through));
  }
  const std::vector<Float3> rest_normal = rest_normals(*surface.topology);
  const std::vector<Vector3> outward = outward_directions(surface, wall, borders);
  // (vertices), of the border edges that end and that begin there.
  std::vector<std::array<Vector3, 2>> around(wall.size());
  for (std::size_t k = 0; k < borders.size(); ++k) {
    around[borders[k].end][0] = outward[k];
    around[borders[k].start][1] = outward[k];
  }
  for (std::size_t k = 0; k < borders.size(); ++k) {
    const auto first = static_cast<std::uint32_t>(depth.rim.size());
    for (const auto& [v, neighbour] : {std::pair{borders[k].start, 0U}, std::pair{borders[k].end, 1U}}) {
      const Vector3 other = around[v][neighbour];
      const bool smooth = dot(other, outward[k]) > kSmoothCosine;
      const Vector3 square = smooth ? normalized(outward[k] + other) : outward[k];
      const Float3 normal = float3(std::sqrt(1 - lean[v] * lean[v]) * square - lean[v] * way_through[v]);
      for (const auto& [side, inwards] : {std::pair{wall[v], 0.0f}, std::pair{depth.lining[v], 1.0f}}) {
        SurfaceVertex vertex = side;
        vertex.normal = normal;
        vertex.curvature = 0;
        vertex.wound = inwards;
        // Through the wall the pattern goes on as it does along it.
        const double rest_depth = inwards * surface.topology->thickness[borders[k].triangle];
        vertex.rest = float3(vector3(vertex.rest) - rest_depth * vector3(rest_normal[v]));
        depth.rim.push_back(vertex);
      }
    }
    // Outer and inner start, outer and inner end: counter-clockwise seen from where the normal leads.
    for (const std::uint32_t corner : {0U, 1U, 2U, 2U, 1U, 3U}) depth.rim_corners.push_back(first + corner);
  }
  return depth;
}

std::vector<SurfaceVertex> inner_side(const SnapshotSurface& surface, std::span<const SurfaceVertex> wall) {
  const bool is_known = surface.topology->thickness.size() == surface.topology->triangles.size();
  const std::vector<double> thickness = is_known ? thickness_now(surface) : std::vector<double>(wall.size(), 0);
  std::vector<SurfaceVertex> inner;
  for (std::size_t v = 0; v < wall.size(); ++v) {
    const double bulge = std::max(-static_cast<double>(wall[v].curvature), 0.0);
    const double drawn = thickness[v] / std::max(1.0, 2 * bulge * thickness[v]);
    inner.push_back(inner_vertex(wall[v], -drawn * vector3(wall[v].normal)));
  }
  return inner;
}

}  // namespace thinwall
