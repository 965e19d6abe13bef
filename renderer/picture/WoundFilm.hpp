#pragma once

#include <span>
#include <vector>

#include "renderer/picture/Film.hpp"
#include "renderer/picture/TissuePieces.hpp"
#include "renderer/wound/RunPath.hpp"
#include "renderer/wound/WoundMap.hpp"

namespace thinwall {

/// What of a wall's wounds stays while no cut changes it.
struct WoundLayout {
  WoundMap map;
  std::vector<double> fall;  // (vertices), of lips: -1 to 1, how far the wall falls away from the wound
  std::vector<FluidRun> blood_runs;
  std::vector<FluidRun> fluid_runs;
};

/// `is_lip`: what cut_lips gives; `down`: the sense in which fluids run.
WoundLayout lay_out_wounds(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                           std::span<const char> is_lip, Vector3 down);

/// The blood on a wall at `time` (seconds): what wells up along the lips and on the cut itself, and what runs down from
/// there. `bleeding`: 0 to 1.
Film blood_film(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                std::span<const TissuePiece> pieces, const WoundLayout& wounds, double bleeding, double time);

/// What has run out of a body, `leaked` (metres^3), on its wall at `time` (seconds): along the lips and down from
/// there.
Film runoff_film(const SnapshotSurface& surface, std::span<const TissuePiece> pieces, const WoundLayout& wounds,
                 double leaked, double time);

/// How what has run out of a body runs: half of its width, its height and its speed. Metres, metres / second.
double runoff_half_width(const FluidRun& run);
inline constexpr double kRunoffHeight = 0.0006;
inline constexpr double kRunoffSpeed = 0.045;

/// What is bare of a wall beside its cut lips, where the outermost layer has drawn back.
Film bare_edge_film(const SnapshotSurface& surface, std::span<const TissuePiece> pieces, const WoundLayout& wounds,
                    double time);

}  // namespace thinwall
