#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/camera/View.hpp"
#include "renderer/shape/TissuePieces.hpp"
#include "renderer/wound/DrawnTopology.hpp"

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

/// What an open sheet lies on, for wounds to be seen into: the stress-free sheet, `below` (metres) it. Towards borders
/// that were there before any cut it comes up to the sheet, so that also a cut that ends beside one shows it; along
/// those that have moved a strip is left out, so that it is not seen beside the sheet. Empty for sheets without such
/// borders.
TissuePiece wound_bed(const SnapshotSurface& surface, std::span<const BorderEdge> borders, std::span<const char> is_lip,
                      double below);

/// The beds of a scene's sheets, and what lies on them.
struct WoundBeds {
  std::vector<double> depths;    // (surfaces), metres below the stress-free sheet; 0: there is none
  std::optional<Snapshot> laid;  // with the pieces that were cut free on the beds; none where all is as it was
};

/// As the surfaces hang and as they are drawn: `drawn`, `shown` (surfaces) are what drawn_topology and drawn_surface
/// give.
WoundBeds lay_on_beds(const Snapshot& snapshot, const LookDefinition& look, std::span<const DrawnTopology> drawn,
                      std::span<const SnapshotSurface> shown);

/// The snapshot as pictures of this look show it: with the pieces that were cut free on the beds of their wounds.
Snapshot laid_on_beds(const Snapshot& snapshot, const LookDefinition& look);

}  // namespace thinwall
