#pragma once

#include <array>
#include <span>
#include <vector>

#include "renderer/picture/Vector.hpp"
#include "renderer/snapshot/BorderEdges.hpp"

namespace thinwall {

/// A place of a wall: a triangle and the weights of its corners, which sum to 1.
struct WallPlace {
  std::uint32_t triangle = 0;
  Triangle corners = {0, 0, 0};  // vertices of that triangle
  Double3 weights = {1, 0, 0};
};

/// Where a fluid leaves a wound and the way that it takes down the stress-free wall.
struct FluidRun {
  std::vector<WallPlace> path;  // from the lip on, kRunStep apart on the stress-free wall
  double born = 0;              // seconds, when the cut came there
  double chance = 0;            // 0 to 1, of this run: what tells it from its neighbours
};

inline constexpr double kRunStep = 0.0008;  // metres

/// Runs that begin at the lips, at least `spacing` (metres, stress-free) from each other, where the wall falls away
/// from the wound along `down` (of length one). Older lips go first, so that runs stay while a cut goes on. Each
/// follows the slope of the stress-free wall, from which it swerves a little to both sides, for at most `longest`
/// metres, to where the wall is level, turns under, or ends.
std::vector<FluidRun> find_runs(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                                std::span<const char> is_lip, Vector3 down, double spacing, double longest);

/// A point between the corners of a place's triangle.
Vector3 point_at(const WallPlace& place, std::span<const Float3> points);

}  // namespace thinwall
