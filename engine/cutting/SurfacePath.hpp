#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "engine/cutting/SurfaceTrace.hpp"

namespace thinwall {

/// A point brought to a surface.
struct SurfaceProjection {
  std::optional<SurfacePoint> point;  // nothing farther than the reach
  double distance = 0;                // metres from the given point, beyond the reach too; infinite: never met
};

/// The nearest point of a surface; with a `direction` (unit) the nearest one of the line along it, forwards or
/// backwards, that faces the direction (on an open surface any). `reach`: metres. A point within 1e-12 of the largest
/// coordinate of an edge or a corner is brought there.
SurfaceProjection project(const SurfaceView& surface, const Eigen::Vector3d& point,
                          const std::optional<Eigen::Vector3d>& direction, double reach);

/// Where one is after a length of way along a path.
struct PathStation {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // metres, on the surface or between the lips of a gap
  Eigen::Vector3d inward = -Eigen::Vector3d::UnitZ();  // unit, into the wall
};

/// A path on a surface, with all that is needed to follow it after the surface has moved on.
struct SurfacePath {
  std::vector<SurfaceCurve> pieces;  // in order; between two of them lies a gap
  /// (stations), the points of all pieces, one after another; gaps are bridged by straight lines.
  std::vector<PathStation> stations;
  std::vector<double> lengths;  // (stations), metres from the beginning, gaps included

  double length() const { return lengths.empty() ? 0 : lengths.back(); }  // metres
  /// Between the two stations around `along` (metres from the beginning, limited to the path).
  PathStation at(double along) const;
};

/// Why there is no path through some points.
struct PathProblem {
  enum class Kind { kOffSurface, kAlongNormal, kNotJoined };
  Kind kind = Kind::kOffSurface;
  int point = 0;        // index; of two points that cannot be joined the second
  double distance = 0;  // metres from the surface, kOffSurface only; may be infinite
};

struct PathResult {
  SurfacePath path;
  std::optional<PathProblem> problem;  // then the path is empty
};

/// The path through points in space, each brought to the surface by `project`, neighbours joined by `trace`. Inward
/// normals are those of the vertices, interpolated: continuous along each piece. On an open surface the inner side is
/// the one that `direction` points to, where it is given; otherwise that behind the triangles.
PathResult surface_path(const SurfaceView& surface, std::span<const Eigen::Vector3d> points,
                        const std::optional<Eigen::Vector3d>& direction, double reach);

/// The path through points of the surface, neighbours joined by `trace`; as above from there. Points that have been
/// carried over a cut (carried_over) become a path again, in pieces where the cut now lies between two of them.
/// `from_behind`: the inner side is the one in front of the triangles.
PathResult path_through(const SurfaceView& surface, std::span<const SurfacePoint> points, bool from_behind = false);

}  // namespace thinwall
