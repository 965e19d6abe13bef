#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/mesh/SurfacePoint.hpp"
#include "engine/tool/Tool.hpp"

namespace thinwall {

/// Where a line enters a surface.
struct SurfaceEntry : SurfacePoint {
  double travel = 0;  // metres along the direction to get there
};

/// A surface as it is now. What it refers to outlives it.
struct SurfaceView {
  std::span<const Eigen::Vector3i> triangles;  // (triangles x 3)
  const Eigen::VectorXd& position;             // (3 vertices), metres
  bool open = false;                           // encloses nothing: then both sides are outer ones
};

/// The corners of a triangle, metres.
inline std::array<Eigen::Vector3d, 3> corners_of(const SurfaceView& surface, int triangle) {
  const Eigen::Vector3i& vertices = surface.triangles[triangle];
  return {surface.position.segment<3>(3 * vertices[0]), surface.position.segment<3>(3 * vertices[1]),
          surface.position.segment<3>(3 * vertices[2])};
}

/// Where the line through `origin` along the unit `direction` first enters the surface from outside, or nothing.
/// The line has no beginning: `travel` may be negative. A hit counts as entry where the line meets the outer side.
std::optional<SurfaceEntry> first_entry(const SurfaceView& surface, const Eigen::Vector3d& origin,
                                        const Eigen::Vector3d& direction);

/// As `first_entry`, for the segment from `begin` to `end` only; `travel` is from `begin`.
std::optional<SurfaceEntry> first_entry_on_segment(const SurfaceView& surface, const Eigen::Vector3d& begin,
                                                   const Eigen::Vector3d& end);

/// Of all the places where the segment from `begin` to `end` enters the surface the one nearest to `place`, or nothing;
/// `travel` is from `begin`.
std::optional<SurfaceEntry> nearest_entry_on_segment(const SurfaceView& surface, const Eigen::Vector3d& begin,
                                                     const Eigen::Vector3d& end, const Eigen::Vector3d& place);

/// The place of a surface that came from ahead of a point to behind it, as one that springs back does over a tool that
/// waits: it meets the line through `point` along the unit `direction` with its outer side, no farther than at the
/// point, and was ahead of it where it was `before`: (3 vertices), metres. Nothing when there is none; the nearest
/// where there are more.
std::optional<SurfaceEntry> overrun_by(const SurfaceView& surface, const Eigen::VectorXd& before,
                                       const Eigen::Vector3d& point, const Eigen::Vector3d& direction);

/// How far a tool can travel from a pose along the unit vector `motion` until it first touches the surface, metres;
/// nothing when it never does. A tool that already touches gives a travel of zero or less. Exact: a solid meets faces,
/// edges and corners, from either side of the surface; a line meets the curve in which its plane of motion cuts it.
std::optional<double> travel_to_contact(const SurfaceView& surface, const ToolDefinition& tool, const ToolPose& pose,
                                        const Eigen::Vector3d& motion);

/// A point where the plane of a line tool's motion cuts an edge of the surface.
struct LineCrossing {
  int triangle = 0;                                   // index, one that has the point
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  // barycentric
  double along = 0;                                   // metres from the tip along the tool's axis
  double travel = 0;                                  // metres from the tip along the direction
};

/// All points where the plane through a line tool and its direction cuts edges of the surface on the side that faces
/// the tool, within its length; each once, in the order of the triangles. A crossing near a vertex is that vertex.
std::vector<LineCrossing> line_crossings(const SurfaceView& surface, const ToolDefinition& tool, const ToolPose& pose);

}  // namespace thinwall
