#pragma once

#include <span>
#include <vector>

#include "renderer/snapshot/BorderEdges.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// How far from a lip a vertex counts as near a wound, metres on the stress-free wall.
inline constexpr double kWoundReach = 0.009;

/// Where both lips of a cut meet in one vertex. While a cut goes on its end moves from vertex to vertex; in between it
/// lies where the last edge's speed brings it.
struct CutEnd {
  double last_edge = 0;  // metres, to the lip before
  double reached = 0;    // seconds, when that lip was cut
  double speed = 0;      // metres/second, there; 0 where the cut does not go on
  /// Metres by which the cut's end is short of the vertex at `time` (seconds).
  double short_by(double time) const;
};

/// Where the vertices of a stress-free wall lie with respect to its wounds.
struct WoundMap {
  static constexpr std::uint32_t kNoLip = 0xffffffff;
  std::vector<double> from_lip;    // (vertices), metres to the nearest lip at rest; of those far away, infinite
  std::vector<std::uint32_t> lip;  // (vertices), the vertex of that lip, or kNoLip
  std::vector<CutEnd> ends;
  std::vector<double> from_end;       // (vertices), of lips: metres along them to the nearest end; infinite without one
  std::vector<std::uint32_t> end_of;  // (vertices), that end, into `ends`
  double length = 0;                  // metres, of all lips

  /// Whether a cut goes on from one place to the next: a puncture is there at once.
  bool goes_on() const;

  /// Metres of all lips at `time` (seconds), as the ends go on.
  double length_at(double time) const;

  /// Metres along a lip from one of its vertices to the nearest end of the cut at `time` (seconds), which goes on
  /// evenly though lips are added edge by edge; infinite without an end.
  double off_end(std::uint32_t vertex, double time) const;

  /// (vertices), of lips: 0 at an end of a cut, growing to 1 away from it, as off_end tells.
  std::vector<double> tapering(double time) const;
};

/// `is_lip`: what cut_lips gives. A lip's ends are where both lips meet in one vertex; those of a cut that runs back
/// into itself are none.
WoundMap map_wounds(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                    std::span<const char> is_lip);

/// (vertices), metres, of lips: how far they are from the other lip's vertex of the same stress-free place; 0 without
/// one.
std::vector<double> lip_gapes(const SnapshotSurface& surface, const WoundMap& map);

}  // namespace thinwall
