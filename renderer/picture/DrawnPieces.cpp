#include "renderer/picture/DrawnPieces.hpp"

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

}  // namespace

std::vector<TissuePiece> drawn_pieces(const SnapshotSurface& mesh, const DrawnTopology& drawn,
                                      const SnapshotSurface& shown) {
  std::vector<SurfaceVertex> wall = wall_vertices(mesh);
  WallWays ways = refined(wall_ways(mesh, wall, drawn.mesh_borders), drawn.smooth);
  for (const CurvePoint& point : drawn.smooth.points) {
    SurfaceVertex vertex = between(wall[point.start], wall[point.end], point.part);
    vertex.position = shown.positions[wall.size()];
    vertex.rest = shown.topology->rest_positions[wall.size()];
    wall.push_back(vertex);
  }
  return tissue_pieces(shown, drawn.borders, std::move(wall), ways);
}

}  // namespace thinwall
