#pragma once

#include <span>
#include <vector>

#include "renderer/shape/Film.hpp"
#include "renderer/shape/TissuePieces.hpp"
#include "renderer/shape/WoundLayout.hpp"

namespace thinwall {

struct Bleeding {
  double strength = 1;  // 0 to 1, how freely the wall bleeds
  double leaked = 0;    // metres^3 that have run out of the body
};

/// The blood of a wound at `time` (seconds): a coat on the faces of the cut and on the ground of the wound, a little of
/// it on the outer side of the lips, and what runs down from there.
Film blood_film(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                std::span<const TissuePiece> pieces, const WoundLayout& wounds, const Bleeding& bleeding, double time);

/// What has run out of a body, `leaked` (metres^3), on its wall at `time` (seconds): along the lips, between
/// those that lie together, and down from there.
Film runoff_film(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                 std::span<const TissuePiece> pieces, const WoundLayout& wounds, double leaked, double time);

/// What of all that has run out of a body (`leaked`, metres^3) each run takes.
double share_of_run(const WoundLayout& wounds, double leaked);

/// How wide and high what has run out of a body is, metres.
struct RunoffSection {
  double half_width = 0;
  double height = 0;
};

/// The more the larger is what it comes out of and the more has come (`leaked`: metres^3, by all runs).
RunoffSection runoff_section(const FluidRun& run, const WoundLayout& wounds, double leaked);
inline constexpr double kRunoffSpeed = 0.045;  // metres / second

/// What is bare of a wall beside its cut lips, where the outermost layer has drawn back, and between those that lie
/// together.
Film bare_edge_film(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                    std::span<const TissuePiece> pieces, const WoundLayout& wounds, double time);

}  // namespace thinwall
