#include "renderer/ground_truth/SceneGeometry.hpp"

#include <algorithm>
#include <cstddef>

#include "renderer/shape/DrawnPieces.hpp"
#include "renderer/shape/ToolShape.hpp"

namespace thinwall {
namespace {

PartKind part_kind(TissueSide side) {
  switch (side) {
    case TissueSide::kRim:
      return PartKind::kRim;
    case TissueSide::kLining:
      return PartKind::kLining;
    case TissueSide::kCap:
    case TissueSide::kCapLining:
      return PartKind::kCap;
    case TissueSide::kBed:  // no part of a body
    case TissueSide::kOutside:
      break;
  }
  return PartKind::kOutside;
}

/// The mesh's triangle behind a piece's.
std::uint32_t wall_triangle(const DrawnTopology& drawn, TissueSide side, std::uint32_t triangle) {
  if (side == TissueSide::kCap) return kNoIndex;
  return drawn.parts()[side == TissueSide::kRim ? drawn.borders[triangle / 2].triangle : triangle].triangle;
}

void append_part(PartKind kind, std::uint32_t owner, std::uint32_t triangles, SceneGeometry& geometry) {
  geometry.parts.push_back({.kind = kind,
                            .owner = owner,
                            .first_triangle = static_cast<std::uint32_t>(geometry.triangles.size()),
                            .triangle_count = triangles});
}

bool is_lining(const TissuePiece& piece) {
  return piece.side == TissueSide::kLining;
}

void append(const TissuePiece& piece, std::uint32_t owner, SceneGeometry& geometry) {
  const DrawnTopology& drawn = geometry.drawn[owner];
  const auto offset = static_cast<std::uint32_t>(geometry.points.size());
  for (const SurfaceVertex& vertex : piece.vertices) {
    geometry.points.push_back(vector3(vertex.position));
    geometry.normals.push_back(vector3(vertex.normal));
  }
  const std::vector<std::uint32_t> vertices = surface_vertices(piece, drawn.topology(), drawn.borders);
  geometry.vertices.insert(geometry.vertices.end(), vertices.begin(), vertices.end());
  const auto count = static_cast<std::uint32_t>(piece.corners.size() / 3);
  append_part(part_kind(piece.side), owner, count, geometry);
  for (std::uint32_t t = 0; t < count; ++t) {
    const std::uint32_t* corners = &piece.corners[3 * std::size_t{t}];
    geometry.triangles.push_back({.corners = {offset + corners[0], offset + corners[1], offset + corners[2]},
                                  .part = static_cast<std::uint32_t>(geometry.parts.size() - 1),
                                  .wall = wall_triangle(drawn, piece.side, t)});
  }
}

void append(const ToolShape& shape, std::uint32_t owner, SceneGeometry& geometry) {
  const auto offset = static_cast<std::uint32_t>(geometry.points.size());
  for (const ToolVertex& vertex : shape.vertices) {
    geometry.points.push_back(vector3(vertex.position));
    geometry.normals.push_back(vector3(vertex.normal));
    geometry.vertices.push_back(kNoIndex);
  }
  append_part(PartKind::kTool, owner, static_cast<std::uint32_t>(shape.indices.size() / 3), geometry);
  for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
    geometry.triangles.push_back(
        {.corners = {offset + shape.indices[i], offset + shape.indices[i + 1], offset + shape.indices[i + 2]},
         .part = static_cast<std::uint32_t>(geometry.parts.size() - 1),
         .wall = kNoIndex});
  }
}

}  // namespace

SceneGeometry scene_geometry(const Snapshot& snapshot, const SceneExtent& extent, DrawnEdges edges, Vector3 eye) {
  SceneGeometry geometry;
  for (std::uint32_t k = 0; k < snapshot.surfaces.size(); ++k) {
    const SnapshotSurface& surface = snapshot.surfaces[k];
    geometry.drawn.push_back(drawn_topology(surface.topology, edges));
    const DrawnTopology& drawn = geometry.drawn.back();
    std::vector<char>& is_cut = geometry.is_cut.emplace_back();
    for (const BorderEdge& edge : drawn.borders) {
      is_cut.push_back(drawn.is_lip[edge.start] != 0 && drawn.is_lip[edge.end] != 0);
    }
    const SnapshotSurface shown = drawn_surface(drawn, surface);
    const std::vector<TissuePiece> pieces = drawn_pieces(surface, drawn, shown, eye);
    for (const TissuePiece& piece : pieces) append(piece, k, geometry);
    // What an opening or a viewer within shows of the inner side was there before, and stays there.
    const bool is_whole = drawn.borders.empty() && !pieces.empty() && pieces.front().side == TissueSide::kOutside;
    if (is_whole && std::ranges::none_of(pieces, is_lining)) {
      append(whole_lining(shown, pieces.front()), k, geometry);
      geometry.parts.back().is_hidden = true;
    }
  }
  for (std::uint32_t k = 0; k < snapshot.tools.size(); ++k) {
    if (!snapshot.tools[k].is_set_aside) {
      append(tool_shape(snapshot.tools[k], extent.subject().size, ToolDetail::kSeen), k, geometry);
    }
  }
  return geometry;
}

}  // namespace thinwall
