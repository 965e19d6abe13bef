#include "renderer/shape/DrawnPieces.hpp"

#include <algorithm>
#include <utility>

#include "renderer/shape/WithinBody.hpp"
#include "renderer/snapshot/Float3.hpp"

namespace thinwall {
namespace {

SurfaceVertex between(const SurfaceVertex& a, const SurfaceVertex& b, double part) {
  const auto number = [&](float SurfaceVertex::*of) { return static_cast<float>((1 - part) * a.*of + part * b.*of); };
  return {.normal = float3(normalized((1 - part) * vector3(a.normal) + part * vector3(b.normal), vector3(a.normal))),
          .blanch = number(&SurfaceVertex::blanch),
          .curvature = number(&SurfaceVertex::curvature),
          .thickness = number(&SurfaceVertex::thickness),
          .wound = number(&SurfaceVertex::wound)};
}

void refine(std::vector<Vector3>& directions, const SmoothSurface& smooth) {
  for (const CurvePoint& point : smooth.points) {
    const Vector3 a = directions[point.start], b = directions[point.end];
    directions.push_back(normalized((1 - point.part) * a + point.part * b, a));
  }
}

WallWays refined(WallWays ways, const SmoothSurface& smooth) {
  if (ways.thickness.empty()) return ways;
  ways.thickness = refined(std::move(ways.thickness), smooth);
  ways.lean = refined(std::move(ways.lean), smooth);
  refine(ways.through, smooth);
  refine(ways.forward, smooth);
  return ways;
}

/// A wall that curls at a lip within a triangle or two lies open on the lip's side, so that there no hollow is dark.
void leave_lips_open(std::span<const char> is_lip, const std::vector<Triangle>& triangles,
                     std::vector<SurfaceVertex>& wall) {
  constexpr float kBesideLip = 0.3F;
  if (std::ranges::none_of(is_lip, [](char lip) { return lip != 0; })) return;
  std::vector<float> left(wall.size(), 1);
  for (const Triangle& triangle : triangles) {
    const bool is_beside = std::ranges::any_of(triangle, [&](std::uint32_t v) { return is_lip[v] != 0; });
    if (!is_beside) continue;
    for (const std::uint32_t v : triangle) left[v] = is_lip[v] ? 0 : kBesideLip;
  }
  for (std::size_t v = 0; v < wall.size(); ++v) {
    if (wall[v].curvature > 0) wall[v].curvature *= left[v];
  }
}

/// Slack lips crumple within a triangle, more sharply than a wall of their thickness does: where a normal is off the
/// way through the wall, which is evened there, it is drawn towards that.
void even_crumples(std::span<const Vector3> through, std::vector<SurfaceVertex>& wall) {
  constexpr double kSlight = 0.95, kSharp = 0.7;  // cosines, below which some of it is evened and most
  constexpr double kMost = 0.8;
  for (std::size_t v = 0; v < through.size(); ++v) {
    const Vector3 normal = vector3(wall[v].normal);
    const double part = kMost * std::clamp((kSlight + dot(normal, through[v])) / (kSlight - kSharp), 0.0, 1.0);
    if (part > 0) wall[v].normal = float3(normalized((1 - part) * normal - part * through[v], normal));
  }
}

}  // namespace

std::vector<TissuePiece> drawn_pieces(const SnapshotSurface& mesh, const DrawnTopology& drawn,
                                      const SnapshotSurface& shown, std::optional<Vector3> eye) {
  std::vector<SurfaceVertex> wall = wall_vertices(mesh);
  leave_lips_open(drawn.is_lip, mesh.topology->triangles, wall);
  WallWays ways = wall_ways(mesh, wall, drawn.mesh_borders);
  even_crumples(ways.through, wall);
  ways = refined(std::move(ways), drawn.smooth);
  for (const CurvePoint& point : drawn.smooth.points) {
    SurfaceVertex vertex = between(wall[point.start], wall[point.end], point.part);
    vertex.position = shown.positions[wall.size()];
    vertex.rest = shown.topology->rest_positions[wall.size()];
    wall.push_back(vertex);
  }
  std::vector<TissuePiece> pieces = tissue_pieces(shown, drawn.borders, std::move(wall), ways);
  const bool is_whole = eye && drawn.borders.empty() && !pieces.empty() && pieces.front().side == TissueSide::kOutside;
  if (is_whole && encloses_its_inside(shown, drawn.borders, pieces) && lies_within(shown, *eye)) {
    pieces.push_back(whole_lining(shown, pieces.front()));
  }
  return pieces;
}

}  // namespace thinwall
