#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "engine/cutting/CutPatch.hpp"
#include "engine/mesh/SurfacePoint.hpp"

namespace thinwall {

enum class PlaceKind {
  kVertex,
  kSide,  // on an edge that bounds a facet or the surface
  kFace   // elsewhere in a facet
};

/// A place on a patch, told by what it lies on and not by its coordinates.
struct PatchPlace {
  PlaceKind kind = PlaceKind::kFace;
  int vertex = -1;                                     // kVertex
  int from = -1, to = -1;                              // kSide: ends of the edge
  double along = 0;                                    // kSide: 0 at `from`, 1 at `to`
  int facet = -1;                                      // kFace
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // metres, rest
};

/// A place where the path changes its facet, or its beginning or end, and the path from there to the next one.
struct PathStop {
  PatchPlace place;
  int facet = -1;                        // that the path goes on in; -1 at the end
  std::vector<Eigen::Vector3d> between;  // corners of the path within that facet, in order
};

/// Reads a path over a patch: points are classified by their zero weights (below 1e-9), and facets follow from what the
/// points lie on. `points` name triangles of the patch. Throws std::invalid_argument when consecutive points have no
/// facet in common.
std::vector<PathStop> read_path(const CutPatch& patch, std::optional<int> from, std::span<const SurfacePoint> points);

/// All corners of a path, in order.
std::vector<Eigen::Vector3d> corners_of(std::span<const PathStop> stops);

/// Distance of a point from a polyline of at least one corner, metres.
double distance_to(std::span<const Eigen::Vector3d> polyline, const Eigen::Vector3d& point);

/// Facets that have a place in their closure.
std::vector<int> facets_at(const CutPatch& patch, const PatchPlace& place);

}  // namespace thinwall
