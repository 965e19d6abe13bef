#pragma once

#include <vector>

#include "renderer/picture/TissuePieces.hpp"
#include "renderer/wound/DrawnTopology.hpp"

namespace thinwall {

/// The pieces of a surface as it is drawn (`shown`: what drawn_surface gives): what its vertices show and how its wall
/// goes through to the inner side is that of `mesh`, and in between along the lips.
std::vector<TissuePiece> drawn_pieces(const SnapshotSurface& mesh, const DrawnTopology& drawn,
                                      const SnapshotSurface& shown);

}  // namespace thinwall
