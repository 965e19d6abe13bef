#include "renderer/ground_truth/Openings.hpp"

#include <algorithm>

#include "renderer/ground_truth/SeenPlaces.hpp"
#include "renderer/wound/WallHole.hpp"

namespace thinwall {
namespace {

bool is_closed(const WallHole& hole, const std::vector<BorderEdge>& borders) {
  return std::ranges::any_of(
      borders, [&](const BorderEdge& edge) { return edge.start == hole.loop.back() && edge.end == hole.loop.front(); });
}

void append_lids(const SnapshotSurface& surface, const DrawnTopology& drawn, SceneGeometry& lids) {
  std::vector<BorderEdge> lips;
  for (const BorderEdge& edge : drawn.borders) {
    if (drawn.is_lip[edge.start] && drawn.is_lip[edge.end]) lips.push_back(edge);
  }
  if (lips.empty()) return;
  const std::vector<Float3> positions = drawn_surface(drawn, surface).positions;
  const auto offset = static_cast<std::uint32_t>(lids.points.size());
  for (const Float3& position : positions) lids.points.push_back(vector3(position));
  for (const WallHole& hole : find_wall_holes(positions, lips)) {
    if (!is_closed(hole, lips)) continue;
    for (const auto& [a, b, c] : hole.lid) lids.triangles.push_back({.corners = {offset + a, offset + b, offset + c}});
  }
}

}  // namespace

std::vector<char> rays_through_openings(const Snapshot& snapshot, const SceneGeometry& geometry,
                                        const Projection& projection) {
  SceneGeometry lids;
  for (std::size_t k = 0; k < snapshot.surfaces.size(); ++k) {
    append_lids(snapshot.surfaces[k], geometry.drawn[k], lids);
  }
  std::vector<char> through(projection.rays().size(), 0);
  if (lids.triangles.empty()) return through;
  const SeenPlaces seen = see(lids, projection);
  for (std::size_t pixel = 0; pixel < through.size(); ++pixel) {
    through[pixel] = seen.places[pixel].triangle != kNoIndex ? 1 : 0;
  }
  return through;
}

}  // namespace thinwall
