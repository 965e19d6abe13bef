#pragma once

#include <span>
#include <vector>

#include "renderer/picture/TissuePieces.hpp"

namespace thinwall {

/// Metres below the stress-free sheet at which the bed of its wounds lies: `depth`, or, where a part of the sheet hangs
/// lower, below that. A piece that was cut free and falls comes to rest `depth` below its place within an eighth of a
/// second.
/// `borders`, `is_lip`: what border_edges and cut_lips give; `time`: seconds.
double bed_depth(const SnapshotSurface& surface, std::span<const BorderEdge> borders, std::span<const char> is_lip,
                 double depth, double time);

/// (vertices x 3), metres, positions of the sheet with those of pieces that were cut free brought back to a bed that
/// lies `below` (metres) the stress-free sheet: what falls comes to rest on it, with its thickness and a gap of 1 mm.
std::vector<Float3> laid_on_bed(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                                std::span<const char> is_lip, double below);

/// What an open sheet lies on, for wounds to be seen into: the stress-free sheet, `below` (metres) it, without a strip
/// along the borders that were there before any cut, so that it is not seen beside the sheet. Empty for sheets without
/// such borders.
TissuePiece wound_bed(const SnapshotSurface& surface, std::span<const BorderEdge> borders, std::span<const char> is_lip,
                      double below);

}  // namespace thinwall
