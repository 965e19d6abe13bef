#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderer/shape/SurfaceVertices.hpp"
#include "renderer/shape/TissueSide.hpp"
#include "renderer/shape/WallThickness.hpp"

namespace thinwall {

/// A body's wall, caps, rims or lining as triangles.
struct TissuePiece {
  TissueSide side = TissueSide::kOutside;
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint32_t> corners;  // (3 x triangles), into `vertices`
};

/// All that is there to be seen of a body, in the order wall, caps, rims, lining; pieces without triangles are left
/// out. Vertices of wall and lining are those of the surface. Caps have three of their own for each triangle; rims have
/// four for each border: the outer and the inner one at its start, then at its end. Triangles of wall, caps and lining
/// are those of the topology; rims have two for each border. `borders`: what border_edges gives; `wall` and `ways`: its
/// vertices and the ways through it.
std::vector<TissuePiece> tissue_pieces(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                                       std::vector<SurfaceVertex> wall, const WallWays& ways);

/// The wall from within where it is whole, as tissue_pieces has it of opened ones.
TissuePiece whole_lining(const SnapshotSurface& surface, const TissuePiece& wall);

/// The caps from within, as an opening of the wall shows them; nothing where there are none.
std::optional<TissuePiece> cap_lining(std::span<const TissuePiece> pieces);

/// Whether `pieces` of the surface close it, with their front sides outwards: walls without a border, and those whose
/// thickness is drawn.
bool encloses_its_inside(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                         std::span<const TissuePiece> pieces);

/// Where a wall ends without a cut, its outer layer goes on over its thickness. `borders` and `is_lip` are those that
/// the pieces were made of.
void cover_open_borders(std::span<const BorderEdge> borders, std::span<const char> is_lip,
                        std::span<TissuePiece> pieces);

/// The surface's vertex behind each vertex of a piece, (vertices).
std::vector<std::uint32_t> surface_vertices(const TissuePiece& piece, const SnapshotTopology& topology,
                                            std::span<const BorderEdge> borders);

}  // namespace thinwall
