#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/cutting/SurfaceCurve.hpp"

namespace thinwall {

/// A plane through a point.
struct CuttingPlane {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    // metres
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit
};

/// On which side of the plane a vertex counts that lies in it.
enum class PlaneTies { kInFront, kBehind };

/// The curves in which a plane meets a surface; borders of the surface end them.
///
/// Exact in its topology: each vertex lies in front of the plane or behind it, those in the plane (to 1e-13 of the
/// largest coordinate) as `ties` says, as if it was shifted by less than any length. An edge is then crossed or not,
/// and a triangle by no or two edges, so that the curves neither branch nor break nor meet, through vertices and along
/// edges too; only where more than two triangles share an edge they end. Triangles in the plane are passed by along
/// the border of what lies in the plane. Points lie in the plane to 1e-12 of the largest coordinate.
std::vector<SurfaceCurve> plane_section(const SurfaceView& surface, const CuttingPlane& plane, PlaneTies ties);

}  // namespace thinwall
