#include "renderer/picture/Outline.hpp"

#include <algorithm>
#include <numeric>

namespace thinwall {
namespace {

struct HalfEdge {
  std::uint64_t key = 0;  // smaller vertex, larger vertex
  MeshEdge edge;
};

HalfEdge half_edge(std::uint32_t start, std::uint32_t end, std::uint32_t opposite) {
  const std::uint64_t low = std::min(start, end), high = std::max(start, end);
  return {low << 32 | high, {.start = start, .end = end, .left = opposite}};
}

}  // namespace

std::vector<MeshEdge> mesh_edges(std::span<const std::uint32_t> corners) {
  std::vector<HalfEdge> halves;
  halves.reserve(corners.size());
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    for (std::size_t side = 0; side < 3; ++side) {
      halves.push_back(half_edge(corners[i + side], corners[i + (side + 1) % 3], corners[i + (side + 2) % 3]));
    }
  }
  std::stable_sort(halves.begin(), halves.end(), [](const HalfEdge& a, const HalfEdge& b) { return a.key < b.key; });
  std::vector<MeshEdge> edges;
  for (std::size_t i = 0; i < halves.size(); ++i) {
    MeshEdge edge = halves[i].edge;
    if (i + 1 < halves.size() && halves[i + 1].key == halves[i].key) edge.right = halves[++i].edge.left;
    edges.push_back(edge);
  }
  return edges;
}

std::vector<std::uint32_t> welded(std::span<const Float3> positions, std::span<const std::uint32_t> corners) {
  std::vector<std::uint32_t> order(positions.size()), first(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return positions[i]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const std::uint32_t a = first[corners[i]], b = first[corners[i + 1]], c = first[corners[i + 2]];
    if (a != b && b != c && c != a) result.insert(result.end(), {a, b, c});
  }
  return result;
}

}  // namespace thinwall
