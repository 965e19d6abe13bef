#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/cutting/SurfaceCurve.hpp"

namespace thinwall {

/// Outer unit normal of a surface at each vertex, (vertices): the normals of its triangles, weighted with their angles
/// there (Thuermer and Wuethrich 1998), which does not depend on how a face is divided. Zero at vertices that no
/// triangle uses.
std::vector<Eigen::Vector3d> vertex_normals(const SurfaceView& surface);

/// Outer unit normal at a point, between those of the vertices around it; that of the triangle where they cancel out.
/// `normals`: from `vertex_normals`.
Eigen::Vector3d smooth_normal(const SurfaceView& surface, const std::vector<Eigen::Vector3d>& normals,
                              const SurfacePoint& point);

/// The same where no other normals are wanted: from the triangles around the point alone.
Eigen::Vector3d smooth_normal(const SurfaceView& surface, const SurfacePoint& point);

}  // namespace thinwall
