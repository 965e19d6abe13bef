#include "renderer/wound/WallHole.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace thinwall {
namespace {

/// The loops of a border; where two touch in a vertex, either may go on there.
std::vector<std::vector<std::uint32_t>> find_loops(std::span<const BorderEdge> borders) {
  std::multimap<std::uint32_t, std::size_t> from;  // edges by their starts
  for (std::size_t k = 0; k < borders.size(); ++k) from.emplace(borders[k].start, k);
  std::vector<char> is_used(borders.size(), 0);
  std::vector<std::vector<std::uint32_t>> loops;
  for (std::size_t first = 0; first < borders.size(); ++first) {
    std::vector<std::uint32_t> loop;
    for (std::size_t k = first; k < borders.size() && !is_used[k];) {
      is_used[k] = 1;
      loop.push_back(borders[k].start);
      const auto [begin, end] = from.equal_range(borders[k].end);
      const auto next = std::find_if(begin, end, [&](const auto& edge) { return !is_used[edge.second]; });
      k = next == end ? borders.size() : next->second;
    }
    if (loop.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops;
}

std::size_t farthest_from_middle(std::span<const std::uint32_t> loop, std::span<const Float3> positions) {
  Vector3 sum;
  for (const std::uint32_t vertex : loop) sum = sum + vector3(positions[vertex]);
  const Vector3 middle = (1.0 / static_cast<double>(loop.size())) * sum;
  std::size_t farthest = 0;
  double most = -1;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double away = length(vector3(positions[loop[i]]) - middle);
    if (away <= most) continue;
    most = away;
    farthest = i;
  }
  return farthest;
}

std::vector<Triangle> strip_across(std::vector<std::uint32_t> loop, std::span<const Float3> positions) {
  // Against the sense of the border, so that each edge of the lid meets its edge of the wall.
  std::ranges::reverse(loop);
  const auto first = static_cast<std::ptrdiff_t>(farthest_from_middle(loop, positions));
  std::rotate(loop.begin(), loop.begin() + first, loop.end());
  const auto distance = [&](std::size_t a, std::size_t b) {
    return length(vector3(positions[loop[a]]) - vector3(positions[loop[b]]));
  };
  std::size_t left = 1, right = loop.size() - 1;
  std::vector<Triangle> lid = {{loop[0], loop[left], loop[right]}};
  while (left + 1 < right) {
    if (distance(left + 1, right) <= distance(left, right - 1)) {
      lid.push_back({loop[left], loop[left + 1], loop[right]});
      ++left;
    } else {
      lid.push_back({loop[left], loop[right - 1], loop[right]});
      --right;
    }
  }
  return lid;
}

/// Of a lid, so that it is seen as one surface.
Vector3 mean_normal(std::span<const Triangle> lid, std::span<const Float3> positions) {
  Vector3 sum;
  for (const auto& [a, b, c] : lid) {
    const Vector3 first = vector3(positions[a]);
    sum = sum + cross(vector3(positions[b]) - first, vector3(positions[c]) - first);
  }
  return normalized(sum);
}

/// How far a border's vertex may lie off the plane of its hole, over the hole's radius, before it counts as that of a
/// flap that stands out.
constexpr double kFlap = 0.3;

/// Without the vertices of flaps.
std::vector<std::uint32_t> without_flaps(const WallHole& hole, std::span<const Float3> positions) {
  const Vector3 normal = mean_normal(hole.lid, positions);
  Vector3 sum;
  std::vector<double> heights;
  for (const std::uint32_t vertex : hole.loop) {
    sum = sum + vector3(positions[vertex]);
    heights.push_back(dot(vector3(positions[vertex]), normal));
  }
  const Vector3 middle = (1.0 / static_cast<double>(hole.loop.size())) * sum;
  double radius = 0;
  for (const std::uint32_t vertex : hole.loop) radius = std::max(radius, length(vector3(positions[vertex]) - middle));
  std::vector<double> sorted = heights;
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2));
  const double plane = sorted[sorted.size() / 2];
  std::vector<std::uint32_t> kept;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (std::abs(heights[k] - plane) <= kFlap * radius) kept.push_back(hole.loop[k]);
  }
  return kept;
}

}  // namespace

HoleMouth mouth_of(const WallHole& hole, std::span<const Float3> positions) {
  const std::vector<std::uint32_t> edge = without_flaps(hole, positions);
  std::vector<Triangle> lid = edge.size() < 3 ? hole.lid : strip_across(edge, positions);
  const Vector3 outward = mean_normal(lid, positions);
  return {.lid = std::move(lid), .outward = outward};
}

std::vector<WallHole> find_wall_holes(std::span<const Float3> positions, std::span<const BorderEdge> borders) {
  std::vector<WallHole> holes;
  for (std::vector<std::uint32_t>& loop : find_loops(borders)) {
    holes.push_back({.loop = loop, .lid = strip_across(loop, positions)});
  }
  return holes;
}

}  // namespace thinwall
