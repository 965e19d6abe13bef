#include "renderer/wound/FringeMesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "renderer/snapshot/Vector.hpp"
#include "renderer/wound/TriangleSplit.hpp"

namespace thinwall {
namespace {

/// By how much a fringe in the middle of an edge may be off that between its ends, metres.
constexpr double kUneven = 0.00003;
constexpr double kMorePieces = 2.5;  // times that, from which on an edge is divided once more
constexpr std::uint32_t kMostPieces = 8;
constexpr double kUsualReach = 0.0014;  // metres, of a fringe away from the ends of its cut

using EdgeKey = std::pair<std::uint32_t, std::uint32_t>;  // vertices, the smaller one first

/// The edges of lips around each lip's vertex, on its own side of the cut.
class LipNeighbours {
 public:
  LipNeighbours(const SnapshotTopology& topology, std::span<const BorderEdge> borders, std::span<const char> is_lip)
      : topology_(topology), beside_(is_lip.size()), around_(is_lip.size()) {
    std::map<Float3, std::uint32_t> numbers;
    place_.assign(is_lip.size(), 0);
    for (std::uint32_t v = 0; v < is_lip.size(); ++v) {
      if (!is_lip[v]) continue;
      place_[v] =
          numbers.try_emplace(topology.rest_positions[v], static_cast<std::uint32_t>(numbers.size())).first->second;
    }
    for (const BorderEdge& edge : borders) {
      if (!is_lip[edge.start] || !is_lip[edge.end]) continue;
      for (const std::uint32_t vertex : {edge.start, edge.end}) beside_[vertex].push_back(edge);
    }
  }

  const std::vector<BorderEdge>& around(std::uint32_t vertex) {
    if (around_[vertex].empty()) walk(vertex);
    return around_[vertex];
  }

 private:
  double length_of(const BorderEdge& edge) const {
    return length(vector3(topology_.rest_positions[edge.end]) - vector3(topology_.rest_positions[edge.start]));
  }

  /// From there both ways at once, so that of the two lips of a cut that on the same side comes first.
  void walk(std::uint32_t vertex) {
    std::vector<std::pair<double, std::uint32_t>> reached = {{0.0, vertex}};
    std::vector<EdgeKey> seen;
    while (!reached.empty()) {
      const auto next = std::ranges::min_element(reached);
      const auto [way, from] = *next;
      reached.erase(next);
      for (const BorderEdge& edge : beside_[from]) {
        const EdgeKey places = std::minmax(place_[edge.start], place_[edge.end]);
        if (std::ranges::find(seen, places) != seen.end()) continue;
        seen.push_back(places);
        around_[vertex].push_back(edge);
        const double farther = way + length_of(edge);
        if (farther < kFringeReach) reached.emplace_back(farther, edge.start == from ? edge.end : edge.start);
      }
    }
  }

  const SnapshotTopology& topology_;
  std::vector<std::uint32_t> place_;             // (vertices), of lips: equal where their stress-free places are
  std::vector<std::vector<BorderEdge>> beside_;  // (vertices), of lips: the edges that meet there
  std::vector<std::vector<BorderEdge>> around_;  // (vertices), once asked for
};

/// Of all `lips`, as `reach` tells for their vertices.
FringeSpread farthest(std::span<const NearLip> lips, std::span<const double> reach) {
  FringeSpread spread{.beyond = -std::numeric_limits<double>::infinity()};
  for (const NearLip& lip : lips) {
    const double beyond = std::lerp(reach[lip.start], reach[lip.end], double{lip.along}) - lip.distance;
    if (beyond > spread.beyond) spread = {.beyond = beyond, .lip = &lip};
  }
  return spread;
}

class FringeMaker {
 public:
  FringeMaker(const SnapshotTopology& topology, std::span<const BorderEdge> borders, std::span<const char> is_lip,
              const WoundMap& map)
      : topology_(topology), map_(map), neighbours_(topology, borders, is_lip) {
    reach_ = map.tapering(std::numeric_limits<double>::infinity());
    for (double& reach : reach_) reach = kUsualReach * std::sqrt(reach);
    for (std::uint32_t v = 0; v < topology.rest_positions.size(); ++v) {
      append(vector3(topology.rest_positions[v]), v, v);
    }
  }

  FringeMesh result() && {
    std::vector<SplitTriangle> pieces;
    for (const Triangle& triangle : topology_.triangles) {
      const bool is_near = std::ranges::any_of(triangle, [&](std::uint32_t v) { return is_beside_lip(v); });
      if (!is_near) continue;
      std::array<std::vector<std::uint32_t>, 3> points;
      for (std::size_t k = 0; k < 3; ++k) points[k] = points_along(triangle[k], triangle[(k + 1) % 3]);
      split_triangle(triangle, points, pieces);
      for (const SplitTriangle& piece : pieces) mesh_.triangles.push_back(piece.vertices);
    }
    mesh_.first_lip.push_back(static_cast<std::uint32_t>(mesh_.lips.size()));
    return std::move(mesh_);
  }

 private:
  bool is_beside_lip(std::uint32_t vertex) const {
    return map_.lip[vertex] != WoundMap::kNoLip && map_.from_lip[vertex] < kFringeReach;
  }

  /// The lips around a place between two vertices: those of the nearer one.
  std::vector<NearLip> near(Vector3 place, std::uint32_t first, std::uint32_t second) {
    const std::uint32_t lip = map_.lip[map_.from_lip[second] < map_.from_lip[first] ? second : first];
    std::vector<NearLip> lips;
    if (lip == WoundMap::kNoLip) return lips;
    for (const BorderEdge& edge : neighbours_.around(lip)) {
      const Vector3 start = vector3(topology_.rest_positions[edge.start]);
      const Vector3 span = vector3(topology_.rest_positions[edge.end]) - start;
      const double squared = dot(span, span);
      const double along = squared > 0 ? std::clamp(dot(place - start, span) / squared, 0.0, 1.0) : 0;
      lips.push_back({.start = edge.start,
                      .end = edge.end,
                      .along = static_cast<float>(along),
                      .distance = static_cast<float>(length(place - start - along * span))});
    }
    return lips;
  }

  std::uint32_t append(Vector3 place, std::uint32_t first, std::uint32_t second) {
    mesh_.first_lip.push_back(static_cast<std::uint32_t>(mesh_.lips.size()));
    const std::vector<NearLip> lips = near(place, first, second);
    mesh_.lips.insert(mesh_.lips.end(), lips.begin(), lips.end());
    usual_.push_back(farthest(lips, reach_).beyond);
    return static_cast<std::uint32_t>(usual_.size() - 1);
  }

  Vector3 between(EdgeKey edge, double part) const {
    return (1 - part) * vector3(topology_.rest_positions[edge.first]) +
           part * vector3(topology_.rest_positions[edge.second]);
  }

  /// How many pieces, a power of two, make the fringe along an edge even.
  std::uint32_t pieces_of(EdgeKey edge) {
    const double first = usual_[edge.first], second = usual_[edge.second];
    if (!(std::max(first, second) > -kFringeReach) || !std::isfinite(first + second)) return 1;
    const double middle = farthest(near(between(edge, 0.5), edge.first, edge.second), reach_).beyond;
    double uneven = std::abs(0.5 * (first + second) - middle);
    std::uint32_t pieces = 1;
    for (; uneven > kUneven && pieces < kMostPieces; pieces *= 2) uneven /= kMorePieces;
    return pieces;
  }

  /// The points on an edge, in its sense; the same for both its triangles.
  std::vector<std::uint32_t> points_along(std::uint32_t from, std::uint32_t to) {
    const EdgeKey edge = std::minmax(from, to);
    const auto [found, is_new] = points_.try_emplace(edge);
    if (is_new) {
      const std::uint32_t pieces = pieces_of(edge);
      for (std::uint32_t k = 1; k < pieces; ++k) {
        const double part = static_cast<double>(k) / pieces;
        mesh_.points.push_back({.start = edge.first, .end = edge.second, .part = part});
        found->second.push_back(append(between(edge, part), edge.first, edge.second));
      }
    }
    std::vector<std::uint32_t> points = found->second;
    if (from > to) std::ranges::reverse(points);
    return points;
  }

  const SnapshotTopology& topology_;
  const WoundMap& map_;
  LipNeighbours neighbours_;
  std::vector<double> reach_;  // (vertices), metres, of lips: as it usually is in the end
  std::vector<double> usual_;  // (vertices and points), metres beyond them, then
  FringeMesh mesh_;
  std::map<EdgeKey, std::vector<std::uint32_t>> points_;
};

}  // namespace

FringeMesh fringe_mesh(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                       std::span<const char> is_lip, const WoundMap& map) {
  return FringeMaker(topology, borders, is_lip, map).result();
}

FringeSpread spread_at(const FringeMesh& mesh, std::uint32_t vertex, std::span<const double> reach) {
  const std::uint32_t first = mesh.first_lip[vertex], end = mesh.first_lip[vertex + 1];
  return farthest(std::span(mesh.lips).subspan(first, end - first), reach);
}

}  // namespace thinwall
