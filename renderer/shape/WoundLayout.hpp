#pragma once

#include <span>
#include <vector>

#include "renderer/wound/FringeMesh.hpp"
#include "renderer/wound/RunPath.hpp"
#include "renderer/wound/WoundMap.hpp"

namespace thinwall {

/// From the ends of a cut, metres, where it hardly gapes and no blood comes over the lips of a level wall.
inline constexpr double kPoolsOffEnds = 0.006;

/// What of a wall's wounds stays while no cut changes it.
struct WoundLayout {
  WoundMap map;
  FringeMesh fringe;         // of the wall as it is drawn
  std::vector<double> fall;  // (vertices), of lips: -1 to 1, how far the wall falls away from the wound
  std::vector<FluidRun> blood_runs;
  std::vector<FluidRun> fluid_runs;
  std::vector<double> blood_feet, fluid_feet;  // (vertices), of lips: see run_feet
};

/// All but the fringe, which fringe_mesh gives once the wall is as fine as it is drawn. `is_lip`: what cut_lips gives;
/// `down`: the sense in which fluids run.
WoundLayout lay_out_wounds(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                           std::span<const char> is_lip, Vector3 down);

}  // namespace thinwall
