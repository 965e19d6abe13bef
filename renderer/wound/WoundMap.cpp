#include "renderer/wound/WoundMap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace thinwall {
namespace {

/// Along this part of a lip's whole length, but no farther than kLongestTaper, it narrows towards its end.
constexpr double kTaperPart = 0.2;
constexpr double kLongestTaper = 0.005;  // metres

double distance(const SnapshotTopology& topology, std::uint32_t a, std::uint32_t b) {
  return length(vector3(topology.rest_positions[b]) - vector3(topology.rest_positions[a]));
}

using Edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Lets what is known at some places of a graph spread along edges until no way is shorter: `pass` takes an edge's ends
/// and tells whether it has shortened one. Wounds are small, so few sweeps do.
template <typename Pass>
void sweep(const Edges& edges, const Pass& pass) {
  for (bool changes = true; changes;) {
    changes = false;
    for (const auto& [a, b] : edges) changes = pass(a, b) || changes;
  }
}

/// The vertex beside `vertex` along `edges` that is not `other`; `vertex` where there is none.
std::uint32_t beside(const Edges& edges, std::uint32_t vertex, std::uint32_t other) {
  for (const auto& [start, end] : edges) {
    if (start == vertex && end != other) return end;
    if (end == vertex && start != other) return start;
  }
  return vertex;
}

CutEnd cut_end(const SnapshotTopology& topology, const Edges& edges, std::uint32_t vertex) {
  const std::uint32_t lip = beside(edges, vertex, vertex);
  const std::uint32_t before = beside(edges, lip, vertex);
  CutEnd end{.last_edge = distance(topology, vertex, lip)};
  if (topology.cut_times.empty()) return end;
  end.reached = topology.cut_times[lip];
  const double took = end.reached - topology.cut_times[before];
  if (took > 0 && end.reached >= 0) end.speed = distance(topology, lip, before) / took;
  return end;
}

void find_ends(const SnapshotTopology& topology, std::span<const BorderEdge> borders, std::span<const char> is_lip,
               WoundMap& map) {
  std::map<Float3, int> copies;  // of lips, at each stress-free place
  for (const BorderEdge& edge : borders) {
    if (is_lip[edge.start]) ++copies[topology.rest_positions[edge.start]];
  }
  Edges edges;
  for (const BorderEdge& edge : borders) {
    if (!is_lip[edge.start] || !is_lip[edge.end]) continue;
    edges.emplace_back(edge.start, edge.end);
    map.length += distance(topology, edge.start, edge.end);
  }
  map.from_end.assign(is_lip.size(), std::numeric_limits<double>::infinity());
  map.end_of.assign(is_lip.size(), 0);
  for (const auto& [start, end] : edges) {
    if (copies[topology.rest_positions[start]] != 1) continue;
    map.from_end[start] = 0;
    map.end_of[start] = static_cast<std::uint32_t>(map.ends.size());
    map.ends.push_back(cut_end(topology, edges, start));
  }
  const auto pass = [&](std::uint32_t from, std::uint32_t to) {
    const double way = map.from_end[from] + distance(topology, from, to) * (1 + 1e-12);
    if (!(map.from_end[to] > way)) return false;
    map.from_end[to] = way;
    map.end_of[to] = map.end_of[from];
    return true;
  };
  sweep(edges, [&](std::uint32_t a, std::uint32_t b) { return pass(a, b) || pass(b, a); });
}

/// Metres from a place to an edge at rest.
double from_edge(Vector3 place, const SnapshotTopology& topology, const BorderEdge& edge) {
  const Vector3 start = vector3(topology.rest_positions[edge.start]);
  const Vector3 span = vector3(topology.rest_positions[edge.end]) - start, way = place - start;
  const double squared = dot(span, span);
  const double along = squared > 0 ? std::clamp(dot(way, span) / squared, 0.0, 1.0) : 0;
  return length(way - along * span);
}

/// (vertices), metres to the lip that ways along edges of triangles lead to, straight: those ways are longer, each
/// by as much as the triangles happen to lie.
std::vector<double> straight_ways(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                                  std::span<const char> is_lip, const WoundMap& map) {
  // Vertices of lips, and the two edges beside each: more where lips touch.
  std::multimap<std::uint32_t, const BorderEdge*> beside_vertex;
  for (const BorderEdge& edge : borders) {
    if (!is_lip[edge.start] || !is_lip[edge.end]) continue;
    for (const std::uint32_t vertex : {edge.start, edge.end}) beside_vertex.emplace(vertex, &edge);
  }
  std::vector<double> ways = map.from_lip;
  for (std::size_t v = 0; v < ways.size(); ++v) {
    if (map.lip[v] == WoundMap::kNoLip || ways[v] == 0) continue;
    const auto [begin, end] = beside_vertex.equal_range(map.lip[v]);
    for (auto edge = begin; edge != end; ++edge) {
      ways[v] = std::min(ways[v], from_edge(vector3(topology.rest_positions[v]), topology, *edge->second));
    }
  }
  return ways;
}

}  // namespace

double CutEnd::short_by(double time) const {
  return speed > 0 ? std::clamp(last_edge - speed * (time - reached), 0.0, last_edge) : 0;
}

bool WoundMap::goes_on() const {
  return std::ranges::any_of(ends, [](const CutEnd& end) { return end.speed > 0; });
}

double WoundMap::length_at(double time) const {
  double cut = length;
  for (const CutEnd& end : ends) cut -= 2 * end.short_by(time);
  return cut;
}

double WoundMap::off_end(std::uint32_t vertex, double time) const {
  const double way = from_end[vertex];
  return std::isfinite(way) ? way - ends[end_of[vertex]].short_by(time) : way;
}

std::vector<double> WoundMap::tapering(double time) const {
  const double taper = std::min(kLongestTaper, kTaperPart * std::max(length_at(time), 1e-9));
  std::vector<double> parts(from_end.size(), 1);
  for (std::uint32_t v = 0; v < parts.size(); ++v) parts[v] = std::clamp(off_end(v, time) / taper, 0.0, 1.0);
  return parts;
}

WoundMap map_wounds(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                    std::span<const char> is_lip) {
  WoundMap map;
  find_ends(topology, borders, is_lip, map);
  map.from_lip.assign(is_lip.size(), std::numeric_limits<double>::infinity());
  map.lip.assign(is_lip.size(), WoundMap::kNoLip);
  for (std::uint32_t v = 0; v < is_lip.size(); ++v) {
    if (!is_lip[v]) continue;
    map.from_lip[v] = 0;
    map.lip[v] = v;
  }
  Edges edges;
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
  map.from_lip = straight_ways(topology, borders, is_lip, map);
  return map;
}

std::vector<double> lip_gapes(const SnapshotSurface& surface, const WoundMap& map) {
  // To the micrometre: where lips are drawn as curves, each has been computed for itself.
  using Place = std::array<long, 3>;
  std::vector<std::pair<Place, std::uint32_t>> lips;
  for (std::uint32_t v = 0; v < map.lip.size(); ++v) {
    if (map.lip[v] != v) continue;
    const Float3& rest = surface.topology->rest_positions[v];
    lips.push_back({{std::lround(1e6F * rest[0]), std::lround(1e6F * rest[1]), std::lround(1e6F * rest[2])}, v});
  }
  std::ranges::sort(lips);
  std::vector<double> gapes(map.lip.size(), 0);
  for (std::size_t k = 1; k < lips.size(); ++k) {
    if (lips[k].first != lips[k - 1].first) continue;
    const std::uint32_t a = lips[k - 1].second, b = lips[k].second;
    const double gape = length(vector3(surface.positions[b]) - vector3(surface.positions[a]));
    gapes[a] = std::max(gapes[a], gape);
    gapes[b] = std::max(gapes[b], gape);
  }
  return gapes;
}

}  // namespace thinwall
