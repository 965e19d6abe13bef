#include "renderer/ground_truth/Openings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/ground_truth/SeenPlaces.hpp"
#include "renderer/wound/WallHole.hpp"

namespace thinwall {
namespace {

/// Where the border goes on to from the last vertex of a hole: back to the first, or out of the wall at its border.
std::uint32_t end_of(const WallHole& hole, const std::vector<BorderEdge>& borders) {
  std::uint32_t end = hole.loop.front();
  for (const BorderEdge& edge : borders) {
    if (edge.start != hole.loop.back()) continue;
    end = edge.end;
    if (end == hole.loop.front()) break;
  }
  return end;
}

/// What closes the holes of a wall, those within it or those that run out at its border.
SceneGeometry lids_of(const SnapshotSurface& surface, const DrawnTopology& drawn, bool are_within) {
  SceneGeometry lids;
  std::vector<BorderEdge> lips;
  for (const BorderEdge& edge : drawn.borders) {
    if (drawn.is_lip[edge.start] && drawn.is_lip[edge.end]) lips.push_back(edge);
  }
  const std::vector<Float3> positions = drawn_surface(drawn, surface).positions;
  for (const Float3& position : positions) lids.points.push_back(vector3(position));
  for (const WallHole& hole : find_wall_holes(positions, lips)) {
    const std::uint32_t end = end_of(hole, lips);
    if ((end == hole.loop.front()) != are_within) continue;
    for (const Triangle& corners : hole.lid) lids.triangles.push_back({.corners = corners});
    if (!are_within) lids.triangles.push_back({.corners = {hole.loop.back(), end, hole.loop.front()}});
  }
  lids.parts = {{.triangle_count = static_cast<std::uint32_t>(lids.triangles.size())}};
  return lids;
}

}  // namespace

Openings rays_through_openings(const Snapshot& snapshot, const SceneGeometry& geometry, const Projection& projection) {
  const std::size_t pixels = projection.rays().size();
  Openings openings{.within = std::vector<char>(pixels, 0),
                    .depth = std::vector<std::vector<double>>(snapshot.surfaces.size())};
  for (std::size_t k = 0; k < snapshot.surfaces.size(); ++k) {
    if (std::ranges::find(geometry.is_cut[k], 1) == geometry.is_cut[k].end()) continue;
    const SnapshotSurface& surface = snapshot.surfaces[k];
    openings.depth[k].assign(pixels, std::numeric_limits<double>::infinity());
    for (const bool are_within : {true, false}) {
      const SceneGeometry lids = lids_of(surface, geometry.drawn[k], are_within);
      if (lids.triangles.empty()) continue;
      const std::vector<double> depth = see(lids, projection).depth;
      for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        if (are_within && std::isfinite(depth[pixel])) openings.within[pixel] = 1;
        openings.depth[k][pixel] = std::min(openings.depth[k][pixel], depth[pixel]);
      }
    }
  }
  return openings;
}

}  // namespace thinwall
