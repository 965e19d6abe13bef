#pragma once

#include <optional>
#include <vector>

#include "renderer/shape/TissuePieces.hpp"
#include "renderer/wound/DrawnTopology.hpp"

namespace thinwall {

/// The pieces of a surface as it is drawn (`shown`: what drawn_surface gives): what its vertices show and how its wall
/// goes through to the inner side is that of `mesh`, and in between along the lips. Of a whole wall the lining is drawn
/// where the viewer's `eye` (metres) lies within.
std::vector<TissuePiece> drawn_pieces(const SnapshotSurface& mesh, const DrawnTopology& drawn,
                                      const SnapshotSurface& shown, std::optional<Vector3> eye = std::nullopt);

}  // namespace thinwall
