#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/snapshot/BorderEdges.hpp"
#include "renderer/wound/WoundMap.hpp"

namespace thinwall {

/// How far from a lip its fringe may reach, metres on the stress-free wall.
inline constexpr double kFringeReach = 0.0035;

/// A place of a lip near a place of the stress-free wall.
struct NearLip {
  std::uint32_t start = 0, end = 0;  // vertices of the lip's edge
  float along = 0;                   // part of the way from `start` to `end`: the nearest there
  float distance = 0;                // metres
};

/// What lies beside the lips of wounds, fine enough that what wells out of them spreads evenly from corner to corner:
/// around a puncture that is smaller than the wall's triangles it would be a star.
struct FringeMesh {
  /// A point between two vertices of the wall.
  struct Point {
    std::uint32_t start = 0, end = 0;
    double part = 0;  // of the way from `start` to `end`
  };
  std::vector<Point> points;
  std::vector<Triangle> triangles;  // of the wall's vertices and, after them, the points; all beside a lip
  /// The lips around each of these, a place of each of their edges, on its own side of the cut.
  std::vector<NearLip> lips;
  std::vector<std::uint32_t> first_lip;  // (vertices of the wall and points, + 1), into `lips`
};

/// `borders`, `is_lip`: what border_edges and cut_lips give for `topology`; `map`: of it.
FringeMesh fringe_mesh(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                       std::span<const char> is_lip, const WoundMap& map);

/// How far what wells out of lips reaches beyond a vertex of the fringe, metres; below zero where it ends before it.
struct FringeSpread {
  double beyond = 0;
  const NearLip* lip = nullptr;  // from where; nullptr far from wounds
};

/// `reach`: (vertices), metres, of lips: how far what wells out of them spreads around.
FringeSpread spread_at(const FringeMesh& mesh, std::uint32_t vertex, std::span<const double> reach);

}  // namespace thinwall
