#pragma once

#include <span>
#include <vector>

#include "renderer/snapshot/BorderEdges.hpp"

namespace thinwall {

/// Piece of a vertex that belongs to what holds its surface.
inline constexpr std::uint32_t kHeldPiece = 0xffffffff;

/// (vertices), of those that belong to a piece which cuts have parted from all that holds its surface, a vertex of that
/// piece, the same for all of it; of the others kHeldPiece. Of the pieces with lips stay those that reach a border
/// which was there before any cut, as of a sheet, and where none does, as of a closed body, the one of the largest
/// stress-free area. `borders`, `is_lip`: what border_edges and cut_lips give.
std::vector<std::uint32_t> cut_out_pieces(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                                          std::span<const char> is_lip);

/// Likewise, for a surface whose borders are not known; quick where it is in one piece.
std::vector<std::uint32_t> cut_out_pieces(const SnapshotTopology& topology);

}  // namespace thinwall
