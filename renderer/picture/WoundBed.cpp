#include "renderer/picture/WoundBed.hpp"

#include <algorithm>

#include "renderer/picture/Float3.hpp"
#include "renderer/picture/Vector.hpp"
#include "renderer/wound/RestNormals.hpp"

namespace thinwall {
namespace {

/// Width of the strip that is left out over the depth.
constexpr double kStrip = 2;

/// Metres between the lowest part of the sheet and the bed.
constexpr double kGap = 0.001;

double lowest_hanging(const SnapshotSurface& surface, std::span<const Float3> normals) {
  const SnapshotTopology& topology = *surface.topology;
  double lowest = 0;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    lowest =
        std::max(lowest, dot(vector3(topology.rest_positions[v]) - vector3(surface.positions[v]), vector3(normals[v])));
  }
  const double thickness = topology.thickness.empty() ? 0 : *std::ranges::max_element(topology.thickness);
  return lowest + thickness + kGap;
}

}  // namespace

TissuePiece wound_bed(const SnapshotSurface& surface, std::span<const BorderEdge> borders, std::span<const char> is_lip,
                      double depth) {
  const SnapshotTopology& topology = *surface.topology;
  std::vector<Vector3> ends;  // of the sheet
  for (const BorderEdge& edge : borders) {
    if (!is_lip[edge.start] || !is_lip[edge.end]) ends.push_back(vector3(topology.rest_positions[edge.start]));
  }
  TissuePiece bed{.side = TissueSide::kBed, .vertices = {}, .corners = {}};
  if (ends.empty()) return bed;
  const std::vector<Float3> normals = rest_normals(topology);
  const double below = std::max(depth, lowest_hanging(surface, normals));
  std::vector<char> is_kept;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Vector3 place = vector3(topology.rest_positions[v]);
    const Float3 position = float3(place - below * vector3(normals[v]));
    bed.vertices.push_back({.position = position, .normal = normals[v], .rest = topology.rest_positions[v]});
    is_kept.push_back(
        std::ranges::none_of(ends, [&](Vector3 end) { return length(end - place) < kStrip * below; }) ? 1 : 0);
  }
  for (const Triangle& triangle : topology.triangles) {
    if (!std::ranges::all_of(triangle, [&](std::uint32_t v) { return is_kept[v] != 0; })) continue;
    bed.corners.insert(bed.corners.end(), triangle.begin(), triangle.end());
  }
  return bed;
}

}  // namespace thinwall
