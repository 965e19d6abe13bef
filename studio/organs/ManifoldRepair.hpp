#pragma once

#include <Eigen/Core>
#include <vector>

#include "studio/organs/MeshRepair.hpp"

namespace thinwall {

/// Of the area: a patch that has less than this is small beside the body.
inline constexpr double kFlapShare = 0.05;

struct RemovedFlaps {
  int triangles = 0;
  std::vector<Eigen::Vector3d> places;  // the middle of each, units of the surface
};

/// Removes patches that hang on the surface by edges of more than two triangles and end elsewhere in open edges, when
/// they have under `kFlapShare` of the area: they bound no space. A partition has no open edge and stays.
RemovedFlaps remove_flaps(RawSurface& surface);

struct SplitPlaces {
  std::vector<Eigen::Vector3d> edges;     // the middles of edges of more than two triangles that were split apart
  std::vector<Eigen::Vector3d> vertices;  // other vertices in which parts touched
  int turned = 0;                         // triangles that were turned to agree with their neighbours
};

/// Splits the surface where parts of it touch, each part with vertices of its own at the same places. At an edge of
/// more than two triangles those two stay joined that bound the same solid wedge; where the triangles do not take turns
/// in facing into and out of a wedge, the wall branches and the edge stays as it is. Cut along all such edges, the
/// surface must be orientable; otherwise nothing is done. After Guéziec, Taubin, Lazarus, Horn, Cutting and stitching:
/// converting sets of polygons to manifold surfaces, 2001.
SplitPlaces split_apart(RawSurface& surface);

}  // namespace thinwall
