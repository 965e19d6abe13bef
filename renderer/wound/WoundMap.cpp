#include "renderer/wound/WoundMap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace thinwall {
namespace {

/// Along this part of a lip's whole length, but no farther than kLongestTaper, it narrows towards its end.
constexpr double kTaperPart = 0.2;
constexpr double kLongestTaper = 0.005;  // metres

double distance(const SnapshotTopology& topology, std::uint32_t a, std::uint32_t b) {
  return length(vector3(topology.rest_positions[b]) - vector3(topology.rest_positions[a]));
}

/// Lets what is known at some places of a graph spread along edges until no way is shorter: `pass` takes an edge's ends
/// and tells whether it has shortened one. Wounds are small, so few sweeps do.
template <typename Edges, typename Pass>
void sweep(const Edges& edges, const Pass& pass) {
  for (bool changes = true; changes;) {
    changes = false;
    for (const auto& [a, b] : edges) changes = pass(a, b) || changes;
  }
}

std::vector<double> taper_lips(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                               std::span<const char> is_lip) {
  std::map<Float3, int> copies;  // of lips, at each stress-free place
  for (const BorderEdge& edge : borders) {
    if (is_lip[edge.start]) ++copies[topology.rest_positions[edge.start]];
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  double whole = 0;
  for (const BorderEdge& edge : borders) {
    if (!is_lip[edge.start] || !is_lip[edge.end]) continue;
    edges.emplace_back(edge.start, edge.end);
    whole += distance(topology, edge.start, edge.end);
  }
  std::vector<double> from_end(is_lip.size(), std::numeric_limits<double>::infinity());
  for (const auto& [start, end] : edges) {
    if (copies[topology.rest_positions[start]] == 1) from_end[start] = 0;
  }
  sweep(edges, [&](std::uint32_t a, std::uint32_t b) {
    const double way = distance(topology, a, b) * (1 + 1e-12);
    if (from_end[b] > from_end[a] + way) {
      from_end[b] = from_end[a] + way;
    } else if (from_end[a] > from_end[b] + way) {
      from_end[a] = from_end[b] + way;
    } else {
      return false;
    }
    return true;
  });
  const double taper = std::min(kLongestTaper, kTaperPart * std::max(whole, 1e-9));
  std::ranges::transform(from_end, from_end.begin(), [&](double away) { return std::min(1.0, away / taper); });
  return from_end;
}

}  // namespace

WoundMap map_wounds(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                    std::span<const char> is_lip) {
  WoundMap map;
  map.tapering = taper_lips(topology, borders, is_lip);
  map.from_lip.assign(is_lip.size(), std::numeric_limits<double>::infinity());
  map.lip.assign(is_lip.size(), WoundMap::kNoLip);
  for (std::uint32_t v = 0; v < is_lip.size(); ++v) {
    if (!is_lip[v]) continue;
    map.from_lip[v] = 0;
    map.lip[v] = v;
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& triangle : topology.triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(triangle[k], triangle[(k + 1) % 3]);
  }
  const auto spread = [&](std::uint32_t from, std::uint32_t to) {
    if (!(map.from_lip[from] < kWoundReach)) return false;
    const double way = map.from_lip[from] + distance(topology, from, to);
    if (!(map.from_lip[to] > way * (1 + 1e-12))) return false;
    map.from_lip[to] = way;
    map.lip[to] = map.lip[from];
    return true;
  };
  sweep(edges, [&](std::uint32_t a, std::uint32_t b) { return spread(a, b) || spread(b, a); });
  return map;
}

}  // namespace thinwall
