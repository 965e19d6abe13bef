#pragma once

#include <span>
#include <vector>

#include "engine/cutting/Cut.hpp"
#include "engine/cutting/CutPatch.hpp"
#include "engine/cutting/WantedPath.hpp"

namespace thinwall {

/// A patch with the edges along which it will be opened.
struct PlannedCut {
  CutPatch patch;                         // with its edges marked
  std::vector<int> vertices;              // of the path, in order; empty: nothing to cut
  std::vector<TriangleSource> triangles;  // changed ones, numbered as in the patches
  int reached_stop = -1;                  // the last one that the cut gets to: the path's end or the one before
  Eigen::Vector3d reached = Eigen::Vector3d::Zero();  // the place on the path that the last vertex stands for
  bool along_edges = false;                           // no new node finds room
};

/// Cuts stay this close to their paths, in lengths of the longest edge at the cut.
inline constexpr double kSnappingBound = 0.75;

/// A path on a patch.
struct PatchPath {
  CutPatch patch;
  std::vector<PathStop> stops;
};

/// Brings a path into `refined` (`before`, or a refinement of it) such that the angles are as good as the rule of cuts
/// asks: no smaller than the least of kGoodAngle, those of the neighbourhood before, and half of those at which lines
/// of cuts meet. Nodes that leave bad triangles are refused and the path is snapped again; where no choice is left or
/// the snapping bound is missed, the path goes along edges that are there, which needs no new triangle. Nothing is cut
/// where the path is too short to be told from a point.
PlannedCut plan_cut(const PatchPath& before, const PatchPath& refined);

/// Largest distance between the cut and the path up to where the cut has got, metres, rest. Before the lips are opened.
double deviation_of(std::span<const PathStop> stops, const PlannedCut& plan);

/// Corners of the path between its last stop that the cut got to and the next stop, from where the cut is on.
std::vector<Eigen::Vector3d> corners_ahead(std::span<const PathStop> stops, const PlannedCut& plan);

}  // namespace thinwall
