#pragma once

#include <span>
#include <vector>

#include "engine/cutting/CutPatch.hpp"
#include "engine/cutting/WantedPath.hpp"

namespace thinwall {

/// A patch with the edges along which it will be opened.
struct PlannedCut {
  CutPatch patch;                                     // with its edges marked
  std::vector<int> vertices;                          // of the path, in order; empty: nothing to cut
  int reached_stop = -1;                              // the last stop of the path that the cut gets to
  Eigen::Vector3d reached = Eigen::Vector3d::Zero();  // the place on the path that the last vertex stands for
  int snapped_nodes = 0;
  bool along_edges = false;  // no new node finds room
};

/// Brings a path into a patch such that the angles are as good as the rule of cuts asks: no smaller than the least of
/// kGoodAngle, those of the patch before, and half of those at which lines of cuts meet. Nodes that leave bad triangles
/// are refused and the path is snapped again; where no choice is left, the path goes along edges that are there, which
/// needs no new triangle. Nothing is cut where the path is too short to be told from a point.
PlannedCut plan_cut(const CutPatch& patch, std::span<const PathStop> stops);

}  // namespace thinwall
