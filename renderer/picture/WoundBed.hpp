#pragma once

#include <span>

#include "renderer/picture/TissuePieces.hpp"

namespace thinwall {

/// What an open sheet lies on, for wounds to be seen into: the stress-free sheet, `depth` (metres) below it or, where a
/// part of the sheet hangs lower, below that, without a strip along the borders that were there before any cut, so that
/// it is not seen beside the sheet. From a piece that was cut free and falls it comes back to its place within a
/// quarter of a second. `is_lip`: what cut_lips gives; `time`: seconds. Empty for sheets without such borders.
TissuePiece wound_bed(const SnapshotSurface& surface, std::span<const BorderEdge> borders, std::span<const char> is_lip,
                      double depth, double time);

}  // namespace thinwall
