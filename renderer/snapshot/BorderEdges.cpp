#include "renderer/snapshot/BorderEdges.hpp"

#include <algorithm>
#include <utility>

#include "renderer/snapshot/HalfEdges.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {
namespace {

/// Whether a place lies between the ends of an edge and on it.
bool lies_on(Vector3 place, Vector3 start, Vector3 end) {
  constexpr double kOff = 1e-4;  // of the edge's length: places are single precision
  const Vector3 edge = end - start;
  const double squared = dot(edge, edge), part = dot(place - start, edge) / squared;
  const Vector3 off = place - start - part * edge;
  return part > 0 && part < 1 && dot(off, off) < kOff * kOff * squared;
}

/// Border vertices that only one side of a cut has, within an edge of the other side's.
std::vector<std::uint32_t> lips_of_one_side(const std::vector<Float3>& rest, std::span<const BorderEdge> borders,
                                            const std::vector<char>& has_twin) {
  std::vector<std::uint32_t> lips;
  for (const BorderEdge& at : borders) {
    if (has_twin[at.start]) continue;
    const Vector3 place = vector3(rest[at.start]);
    const bool is_lip = std::ranges::any_of(borders, [&](const BorderEdge& edge) {
      return (has_twin[edge.start] || has_twin[edge.end]) && edge.start != at.start && edge.end != at.start &&
             lies_on(place, vector3(rest[edge.start]), vector3(rest[edge.end]));
    });
    if (is_lip) lips.push_back(at.start);
  }
  return lips;
}

}  // namespace

std::vector<BorderEdge> border_edges(const SnapshotTopology& topology) {
  const HalfEdges halves({topology.triangles, topology.cap_triangles});
  std::vector<BorderEdge> borders;
  for (std::uint32_t t = 0; t < topology.triangles.size(); ++t) {
    const Triangle& triangle = topology.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t start = triangle[k], end = triangle[(k + 1) % 3];
      if (halves.triangle_of(end, start) != HalfEdges::kNone) continue;
      borders.push_back({.start = start, .end = end, .triangle = t});
    }
  }
  return borders;
}

std::vector<char> cut_lips(const SnapshotTopology& topology, std::span<const BorderEdge> borders) {
  const std::vector<Float3>& rest = topology.rest_positions;
  std::vector<std::uint32_t> on_border;
  for (const BorderEdge& edge : borders) on_border.push_back(edge.start);
  std::ranges::sort(on_border,
                    [&](std::uint32_t a, std::uint32_t b) { return std::pair(rest[a], a) < std::pair(rest[b], b); });
  std::vector<char> is_lip(rest.size(), 0);
  for (std::size_t i = 1; i < on_border.size(); ++i) {
    if (rest[on_border[i]] != rest[on_border[i - 1]] || on_border[i] == on_border[i - 1]) continue;
    is_lip[on_border[i]] = is_lip[on_border[i - 1]] = 1;
  }
  for (const std::uint32_t vertex : lips_of_one_side(rest, borders, is_lip)) is_lip[vertex] = 1;
  std::vector<int> lip_neighbours(rest.size(), 0);
  for (const BorderEdge& edge : borders) {
    lip_neighbours[edge.start] += is_lip[edge.end];
    lip_neighbours[edge.end] += is_lip[edge.start];
  }
  for (std::size_t v = 0; v < rest.size(); ++v) {
    if (lip_neighbours[v] >= 2) is_lip[v] = 1;
  }
  return is_lip;
}

}  // namespace thinwall
