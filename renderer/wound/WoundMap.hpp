#pragma once

#include <span>
#include <vector>

#include "renderer/picture/Vector.hpp"
#include "renderer/snapshot/BorderEdges.hpp"

namespace thinwall {

/// How far from a lip a vertex counts as near a wound, metres on the stress-free wall.
inline constexpr double kWoundReach = 0.004;

/// Where the vertices of a stress-free wall lie with respect to its wounds.
struct WoundMap {
  static constexpr std::uint32_t kNoLip = 0xffffffff;
  std::vector<double> from_lip;    // (vertices), metres along edges to the nearest lip; of those far away, infinite
  std::vector<std::uint32_t> lip;  // (vertices), the vertex of that lip, or kNoLip
  std::vector<double> tapering;    // (vertices), of lips: 0 at an end of a cut, growing to 1 away from it
};

/// `is_lip`: what cut_lips gives. A lip's ends are where both lips meet in one vertex; those of a cut that runs back
/// into itself are none.
WoundMap map_wounds(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                    std::span<const char> is_lip);

}  // namespace thinwall
