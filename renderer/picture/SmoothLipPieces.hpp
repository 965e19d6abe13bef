#pragma once

#include <span>
#include <vector>

#include "renderer/picture/TissuePieces.hpp"
#include "renderer/wound/SmoothLips.hpp"

namespace thinwall {

/// The pieces of `smooth`, a surface whose lips are curves (`lips`, with the borders `smooth_borders`): what its
/// vertices show and how its wall goes through to the inner side is that of `surface` with its `borders`, and in
/// between along the lips.
std::vector<TissuePiece> smooth_lipped_pieces(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                                              const SmoothLips& lips, const SnapshotSurface& smooth,
                                              std::span<const BorderEdge> smooth_borders);

}  // namespace thinwall
