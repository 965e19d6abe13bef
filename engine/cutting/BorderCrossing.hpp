#pragma once

#include <Eigen/Core>
#include <optional>

#include "engine/mesh/SurfacePoint.hpp"
#include "engine/tool/FirstContact.hpp"

namespace thinwall {

/// Which of several crossings is meant, on the way from one point to the other.
enum class Crossing { kFirst, kLast };

/// Where an open border of a surface crosses the way from one point to another, as seen along the unit vector `line`:
/// it lies in the plane through both points and the line, between them, and no farther aside along the line than they
/// are from each other. Borders at `from` itself do not count. Nothing where no border crosses.
std::optional<SurfacePoint> border_crossing(const SurfaceView& surface, const Eigen::Vector3d& from,
                                            const Eigen::Vector3d& to, const Eigen::Vector3d& line, Crossing which);

/// The sense in which a cut with this tip leads on: away from the borders that meet there, not of unit length; zero
/// where the vertex is at no border.
Eigen::Vector3d way_ahead(const SurfaceView& surface, int tip);

}  // namespace thinwall
