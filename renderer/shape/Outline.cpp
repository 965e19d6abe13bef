#include "renderer/shape/Outline.hpp"

#include <algorithm>
#include <utility>

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

}  // namespace thinwall
