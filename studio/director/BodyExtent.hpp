#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "engine/tool/FirstContact.hpp"

namespace thinwall {

/// How much a surface measures along a unit vector, metres.
double extent_along(const SurfaceView& surface, const Eigen::Vector3d& direction);

/// The box that a surface spans, metres.
Eigen::AlignedBox3d box_of(const SurfaceView& surface);

/// How often a surface winds around a point: 1 inside a closed one, 0 outside; in between where the surface has holes
/// (sum of the solid angles of its triangles over 4 pi, each after Van Oosterom and Strackee 1983).
double winding_number(const SurfaceView& surface, const Eigen::Vector3d& point);

/// Whether a surface that encloses something winds around a point more than half a time.
bool is_inside(const SurfaceView& surface, const Eigen::Vector3d& point);

}  // namespace thinwall
