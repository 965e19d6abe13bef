#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "renderer/snapshot/BorderEdges.hpp"
#include "renderer/snapshot/SurfacePlace.hpp"
#include "renderer/wound/WoundMap.hpp"

namespace thinwall {

/// A place on the curve that an edge of the mesh is drawn as.
struct CurvePoint {
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::uint32_t start = 0, end = 0;             // vertices of the mesh
  double part = 0;                              // of the way from `start` to `end`
  bool is_lip = false;                          // whether the edge is a cut's lip
  std::uint32_t before = kNone, after = kNone;  // vertices along the lip, kNone where it forks or ends, and elsewhere
};

inline constexpr std::uint32_t kLipPieces = 4;   // that an edge of a lip is drawn as
inline constexpr std::uint32_t kEdgePieces = 2;  // that another edge is drawn as where the wall is round

/// Part of a surface's extent at rest (its box's diagonal) by which an edge's middle has to lie off a round wall to be
/// drawn as a curve: half a pixel of a picture that the surface fills.
inline constexpr double kRoundness = 0.0004;

/// A triangle of a finer surface.
struct TrianglePart {
  std::uint32_t triangle = 0;                                                          // of the mesh
  std::array<std::array<double, 3>, 3> corners = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // their weights in that triangle
};

/// A surface whose edges are finer, so that they can be drawn as curves.
struct SmoothSurface {
  std::shared_ptr<const SnapshotTopology> mesh;
  /// Its vertices are those of the mesh and, after them, one for each of `points`. The parts of a triangle of the mesh
  /// follow one another.
  std::shared_ptr<const SnapshotTopology> topology;
  std::vector<CurvePoint> points;
  std::vector<TrianglePart> parts;  // (triangles of `topology`)
};

/// Lips of cuts are made finer, and with `rounds_walls` edges of round walls but for those at caps. The mesh itself
/// with no `points` where there are none. `borders`, `is_lip`: what border_edges and cut_lips give.
SmoothSurface smooth_surface(const std::shared_ptr<const SnapshotTopology>& mesh, std::span<const BorderEdge> borders,
                             std::span<const char> is_lip, bool rounds_walls);

/// The mesh as it is.
SmoothSurface unsmoothed_surface(const std::shared_ptr<const SnapshotTopology>& mesh);

/// `positions` (metres) and those of the points, on curves through the vertices of the mesh (Hermite's). A lip's
/// tangents are those of the circle through a vertex and its neighbours; it stays with its edge where the lip turns
/// sharply, as at the ends of a cut. Other edges leave along the planes square to the normals at their ends (Vlachos et
/// al. 2001, "Curved PN triangles"). None leaves its edge by more than a fifth of its length.
std::vector<Float3> smooth_positions(const SmoothSurface& surface, std::span<const Float3> positions);

/// What the map of the mesh says of the finer surface.
WoundMap refined(WoundMap map, const SmoothSurface& surface);

/// Likewise for a number of each vertex: between those of an edge's ends.
template <typename Number>
std::vector<Number> refined(std::vector<Number> values, const SmoothSurface& surface) {
  for (const CurvePoint& point : surface.points) {
    values.push_back(static_cast<Number>((1 - point.part) * values[point.start] + point.part * values[point.end]));
  }
  return values;
}

}  // namespace thinwall
