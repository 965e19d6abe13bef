#include "renderer/snapshot/CutOutPieces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace thinwall {
namespace {

/// (vertices), a vertex of its piece, the same for all of that piece.
std::vector<std::uint32_t> pieces_of(const SnapshotTopology& topology) {
  std::vector<std::uint32_t> parent(topology.rest_positions.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto* triangles : {&topology.triangles, &topology.cap_triangles}) {
    for (const Triangle& triangle : *triangles) {
      for (const std::uint32_t corner : {triangle[1], triangle[2]}) parent[root(corner)] = root(triangle[0]);
    }
  }
  for (std::uint32_t v = 0; v < parent.size(); ++v) parent[v] = root(v);
  return parent;
}

double rest_area(const Triangle& triangle, const std::vector<Float3>& rest) {
  std::array<double, 3> a, b;
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] = static_cast<double>(rest[triangle[1]][i]) - rest[triangle[0]][i];
    b[i] = static_cast<double>(rest[triangle[2]][i]) - rest[triangle[0]][i];
  }
  return 0.5 * std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}

/// `pieces` (what pieces_of gives), kHeldPiece for those that stay.
std::vector<std::uint32_t> parted(const SnapshotTopology& topology, std::vector<std::uint32_t> pieces,
                                  std::span<const BorderEdge> borders, std::span<const char> is_lip) {
  std::vector<char> is_cut(pieces.size(), 0), is_held(pieces.size(), 0);  // of a piece's own vertex
  for (const BorderEdge& edge : borders) {
    (is_lip[edge.start] && is_lip[edge.end] ? is_cut : is_held)[pieces[edge.start]] = 1;
  }
  const auto is_loose = [&](std::uint32_t piece) { return is_cut[piece] && !is_held[piece]; };
  const bool has_held = std::ranges::any_of(pieces, [&](std::uint32_t p) { return is_cut[p] && is_held[p]; });
  if (!has_held) {
    std::vector<double> areas(pieces.size(), 0);
    for (const Triangle& triangle : topology.triangles) {
      if (is_loose(pieces[triangle[0]])) areas[pieces[triangle[0]]] += rest_area(triangle, topology.rest_positions);
    }
    const auto largest = std::ranges::max_element(areas);
    if (largest != areas.end()) is_held[static_cast<std::size_t>(largest - areas.begin())] = 1;
  }
  for (std::uint32_t& piece : pieces) piece = is_loose(piece) ? piece : kHeldPiece;
  return pieces;
}

}  // namespace

std::vector<std::uint32_t> cut_out_pieces(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                                          std::span<const char> is_lip) {
  return parted(topology, pieces_of(topology), borders, is_lip);
}

std::vector<std::uint32_t> cut_out_pieces(const SnapshotTopology& topology) {
  std::vector<std::uint32_t> pieces = pieces_of(topology);
  const bool is_one = std::ranges::all_of(pieces, [&](std::uint32_t piece) { return piece == pieces.front(); });
  if (is_one) return std::vector<std::uint32_t>(pieces.size(), kHeldPiece);
  const std::vector<BorderEdge> borders = border_edges(topology);
  return parted(topology, std::move(pieces), borders, cut_lips(topology, borders));
}

}  // namespace thinwall
