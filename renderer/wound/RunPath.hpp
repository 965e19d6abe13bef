#pragma once

#include <array>
#include <span>
#include <vector>

#include "renderer/snapshot/BorderEdges.hpp"
#include "renderer/snapshot/Vector.hpp"
#include "renderer/wound/WoundMap.hpp"

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
  bool creeps = false;          // where the wall is level, at first
};

inline constexpr double kRunStep = 0.0008;  // metres

/// Metres on the stress-free wall.
struct RunReach {
  double spacing = 0;             // at least, between where runs begin
  double longest = 0;             // of a run
  double push = 0;                // over level wall, away from the lip, of what comes out under pressure
  double level = 0;               // at most, of what wells over a lip where the wall is level
  double off_begin = 0;           // from where a cut begins, within which nothing creeps: there it hardly gapes
  double off_ends = 0;            // from both ends of a cut, within which nothing begins: there its lips lie together
  const WoundMap* map = nullptr;  // that knows where those are; null: nowhere
};

/// Runs that begin at the lips, where the wall falls away from the wound along `down` (of length one), or does so
/// behind level wall that the push gets them over, as on the crown of a vessel. Older lips go first, so that runs stay
/// while a cut goes on. Each follows the slope of the stress-free wall, from which it swerves a little to both sides,
/// to where the wall is level, turns under, or ends. Where all is level, some of what wells over the lips creeps away
/// from them, over one here and over the other there.
std::vector<FluidRun> find_runs(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                                std::span<const char> is_lip, Vector3 down, const RunReach& reach);

/// A point between the corners of a place's triangle.
Vector3 point_at(const WallPlace& place, std::span<const Float3> points);

}  // namespace thinwall
