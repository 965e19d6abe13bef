#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "engine/mesh/SurfacePoint.hpp"
#include "engine/tool/FirstContact.hpp"

namespace thinwall {

/// Where the way from one point to another first comes to an open border of a surface, as seen along the unit vector
/// `line`: in the plane through both points and the line, between them, and no farther aside along the line than they
/// are from each other. Borders at `from` itself do not count, and one whose wall lies ahead only where there is no
/// other: the lips of a cut that has not opened lie together, or overlap. Nothing where no border crosses.
std::optional<SurfacePoint> first_border(const SurfaceView& surface, const Eigen::Vector3d& from,
                                         const Eigen::Vector3d& to, const Eigen::Vector3d& line);

/// A blade in a gap of a wall.
struct BladeInGap {
  Eigen::Vector3d left = Eigen::Vector3d::Zero();   // metres, where it has left the wall
  Eigen::Vector3d way = Eigen::Vector3d::UnitX();   // unit, along which it goes on
  Eigen::Vector3d line = Eigen::Vector3d::UnitZ();  // unit, across the way, of its edge
  double above = 0, below = 0;                      // metres along the line from `left`: the edge's ends
  std::vector<int> lips = {};  // vertices of the cut that it has just made: borders there do not count
  double overlap = 0;          // metres by which the lips of a closed gap may overlap
};

/// Where a blade that goes straight on comes back into a wall: the border across its way whose wall lies ahead, met at
/// more than 15 degrees, that is nearest to where it left. Nothing where there is none.
std::optional<SurfacePoint> border_beyond(const SurfaceView& surface, const BladeInGap& blade);

/// The place of an open border that is nearest to a point; nothing where a surface has none.
std::optional<SurfacePoint> nearest_on_border(const SurfaceView& surface, const Eigen::Vector3d& point);

/// Of each side of open borders the place nearest to a point, where that is within `reach` metres; in the order of the
/// triangles.
std::vector<SurfacePoint> borders_around(const SurfaceView& surface, const Eigen::Vector3d& point, double reach);

/// Metres from a point to the nearest place of an open border; infinity where a surface has none.
double distance_from_border(const SurfaceView& surface, const Eigen::Vector3d& point);

/// Where a line, through `origin` along the unit `direction`, first meets the rim of a wall: passes an open border
/// within half of the thickness there. `thickness`: (triangles), metres. Nothing where it meets none.
std::optional<SurfaceEntry> first_rim(const SurfaceView& surface, std::span<const double> thickness,
                                      const Eigen::Vector3d& origin, const Eigen::Vector3d& direction);

/// The sense in which a cut with this tip leads on: away from the borders that meet there, not of unit length; zero
/// where the vertex is at no border.
Eigen::Vector3d way_ahead(const SurfaceView& surface, int tip);

}  // namespace thinwall
