#include "renderer/shape/TissuePieces.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "renderer/snapshot/Float3.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {
namespace {

/// The same triangles, seen from their other side.
std::vector<std::uint32_t> turned_over(std::vector<std::uint32_t> corners) {
  for (std::size_t c = 0; c + 3 <= corners.size(); c += 3) std::swap(corners[c + 1], corners[c + 2]);
  return corners;
}

}  // namespace

std::vector<TissuePiece> tissue_pieces(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                                       std::vector<SurfaceVertex> wall_vertices, const WallWays& ways) {
  const std::vector<Triangle>& triangles = surface.topology->triangles;
  TissuePiece wall{.side = TissueSide::kOutside, .vertices = std::move(wall_vertices), .corners = {}};
  for (const Triangle& triangle : triangles) {
    wall.corners.insert(wall.corners.end(), triangle.begin(), triangle.end());
  }
  TissuePiece caps{.side = TissueSide::kCap, .vertices = cap_vertices(surface), .corners = {}};
  caps.corners.resize(caps.vertices.size());
  std::iota(caps.corners.begin(), caps.corners.end(), 0U);
  WallDepth depth = wall_depth(surface, wall.vertices, borders, ways);
  TissuePiece rim{.side = TissueSide::kRim, .vertices = std::move(depth.rim), .corners = std::move(depth.rim_corners)};
  TissuePiece lining{.side = TissueSide::kLining, .vertices = std::move(depth.lining), .corners = {}};
  if (!lining.vertices.empty()) lining.corners = turned_over(wall.corners);
  std::vector<TissuePiece> pieces;
  for (TissuePiece* piece : {&wall, &caps, &rim, &lining}) {
    if (!piece->corners.empty()) pieces.push_back(std::move(*piece));
  }
  return pieces;
}

TissuePiece whole_lining(const SnapshotSurface& surface, const TissuePiece& wall) {
  TissuePiece lining{.side = TissueSide::kLining, .vertices = inner_side(surface, wall.vertices), .corners = {}};
  lining.corners = turned_over(wall.corners);
  return lining;
}

std::optional<TissuePiece> cap_lining(std::span<const TissuePiece> pieces) {
  const auto caps = std::ranges::find(pieces, TissueSide::kCap, &TissuePiece::side);
  if (caps == pieces.end()) return std::nullopt;
  TissuePiece lining{.side = TissueSide::kCapLining, .vertices = caps->vertices, .corners = turned_over(caps->corners)};
  for (SurfaceVertex& vertex : lining.vertices) vertex.normal = float3(-vector3(vertex.normal));
  return lining;
}

bool encloses_its_inside(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                         std::span<const TissuePiece> pieces) {
  if (!borders.empty()) return std::ranges::find(pieces, TissueSide::kLining, &TissuePiece::side) != pieces.end();
  double volume = 0;
  for (const auto* triangles : {&surface.topology->triangles, &surface.topology->cap_triangles}) {
    for (const Triangle& triangle : *triangles) {
      const Vector3 from = vector3(surface.positions[triangle[0]]);
      const Vector3 to = vector3(surface.positions[triangle[1]]), last = vector3(surface.positions[triangle[2]]);
      volume += dot(from, cross(to, last));
    }
  }
  return volume > 0;
}

/// Before where the outer layer ends, however wavy that is.
constexpr float kCovered = -0.1F;

void cover_open_borders(std::span<const BorderEdge> borders, std::span<const char> is_lip,
                        std::span<TissuePiece> pieces) {
  for (TissuePiece& piece : pieces) {
    if (piece.side != TissueSide::kRim) continue;
    for (std::size_t v = 0; v < piece.vertices.size(); ++v) {
      const BorderEdge& border = borders[v / 4];
      if (!is_lip[border.start] || !is_lip[border.end]) piece.vertices[v].wound = kCovered;
    }
  }
}

std::vector<std::uint32_t> surface_vertices(const TissuePiece& piece, const SnapshotTopology& topology,
                                            std::span<const BorderEdge> borders) {
  std::vector<std::uint32_t> vertices(piece.vertices.size());
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    vertices[v] = v;
    if (piece.side == TissueSide::kCap) vertices[v] = topology.cap_triangles[v / 3][v % 3];
    if (piece.side == TissueSide::kRim) vertices[v] = v % 4 < 2 ? borders[v / 4].start : borders[v / 4].end;
  }
  return vertices;
}

}  // namespace thinwall
