#include "renderer/picture/CutLips.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "renderer/picture/Vector.hpp"

namespace thinwall {
namespace {

/// (vertices), whether a vertex lies on a border, and another one on a border has its stress-free position; the tips
/// between two such vertices count too.
std::vector<char> find_lips(const SnapshotTopology& topology, std::span<const BorderEdge> borders) {
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

}  // namespace

std::vector<float> nearness_to_cuts(const SnapshotTopology& topology, std::span<const BorderEdge> borders) {
  const std::vector<char> is_lip = find_lips(topology, borders);
  std::vector<double> distance(is_lip.size());
  constexpr double kFar = (1.0 - kUncut) * kWoundReach;
  std::ranges::transform(is_lip, distance.begin(), [](char lip) { return lip ? 0.0 : kFar; });
  // Few triangles lie within the reach, so some sweeps over all of them do.
  for (bool changes = true; changes;) {
    changes = false;
    for (const Triangle& triangle : topology.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
        if (std::min(distance[a], distance[b]) >= kWoundReach) continue;
        const double away = length(vector3(topology.rest_positions[b]) - vector3(topology.rest_positions[a]));
        for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
          if (distance[to] <= distance[from] + away * (1 + 1e-12)) continue;
          distance[to] = distance[from] + away;
          changes = true;
        }
      }
    }
  }
  std::vector<float> nearness(distance.size());
  std::ranges::transform(distance, nearness.begin(), [](double d) { return static_cast<float>(1 - d / kWoundReach); });
  return nearness;
}

}  // namespace thinwall
