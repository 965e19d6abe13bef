#pragma once

#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// Where the tree of vessels stands that a wall bears: around a line through the stress-free body, from its slender end
/// to its full one, as vessels come in along the neck of an organ. Metres. It is told by moments of the whole wall,
/// which cuts leave as they are.
struct VesselTree {
  Vector3 middle;              // of the line
  Vector3 along = {1, 0, 0};   // of length one, towards the full end
  Vector3 across = {0, 1, 0};  // of length one, perpendicular to it
  double half_length = 0.01;   // of the line
  double radius = 0.01;        // mean distance of the wall from the line
};

/// Of a sheet the line lies below it, as far as it is wide, or all of the sheet would look the same from there.
VesselTree vessel_tree(const SnapshotTopology& topology);

/// How many trunks start at the slender end: `spacing` metres are between the branches of most of the wall.
double vessel_trunks(const VesselTree& tree, double spacing);

}  // namespace thinwall
