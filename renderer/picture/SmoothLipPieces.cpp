#include "renderer/picture/SmoothLipPieces.hpp"

#include <utility>

#include "renderer/picture/Float3.hpp"

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

void refine(std::vector<Vector3>& directions, const SmoothLips& lips) {
  for (const LipPoint& point : lips.points) {
    const Vector3 a = directions[point.start], b = directions[point.end];
    directions.push_back(normalized((1 - point.part) * a + point.part * b, a));
  }
}

WallWays refined(WallWays ways, const SmoothLips& lips) {
  if (ways.thickness.empty()) return ways;
  ways.thickness = refined(std::move(ways.thickness), lips);
  ways.lean = refined(std::move(ways.lean), lips);
  refine(ways.through, lips);
  refine(ways.forward, lips);
  return ways;
}

}  // namespace

std::vector<TissuePiece> smooth_lipped_pieces(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                                              const SmoothLips& lips, const SnapshotSurface& smooth,
                                              std::span<const BorderEdge> smooth_borders) {
  std::vector<SurfaceVertex> wall = wall_vertices(surface);
  WallWays ways = refined(wall_ways(surface, wall, borders), lips);
  for (const LipPoint& point : lips.points) {
    SurfaceVertex vertex = between(wall[point.start], wall[point.end], point.part);
    vertex.position = smooth.positions[wall.size()];
    vertex.rest = smooth.topology->rest_positions[wall.size()];
    wall.push_back(vertex);
  }
  return tissue_pieces(smooth, smooth_borders, std::move(wall), ways);
}

}  // namespace thinwall
