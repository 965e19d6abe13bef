#pragma once

#include <Eigen/Core>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "engine/cutting/WantedPath.hpp"

namespace thinwall {

// Lengths in edge lengths of the original mesh. Where the path crosses an edge that no flip can remove, it goes through
// one of the ends or through a point at least kLeastPart of the edge length away from both, so that no sliver arises.
inline constexpr double kLeastPart = 0.3;
inline constexpr double kClearance = 0.22;  // of nodes in faces from edges that stay
inline constexpr double kLeastStep = 0.4;   // between nodes of the cut within a facet

/// A place that the cut goes through.
struct PathNode {
  PatchPlace place;
  int facet = -1;              // that the cut goes on in
  int stop = -1, passed = -1;  // the stop of the path that it belongs to, and the last one that lies behind it
  int choice = -1;             // which of the places for that stop
  Eigen::Vector3d wanted = Eigen::Vector3d::Zero();  // metres, the place on the path
};

/// Choices (stop, choice) that are known to leave bad triangles.
using RefusedChoices = std::set<std::pair<int, int>>;

/// The nodes of the cut: for each stop of the path one of few places (the crossing itself, points of its edge, the ends
/// of the edge), such that the sum over the path of squared distance from it, squared change of that distance (for
/// smooth lips) and penalties for angles that are not allowed is least (dynamic programming); between stops in flat
/// pieces the path itself at steps of about one edge length.
std::vector<PathNode> snap_path(const CutPatch& patch, std::span<const PathStop> stops, const RefusedChoices& refused);

}  // namespace thinwall
