#pragma once

#include <Eigen/Core>
#include <array>

namespace thinwall {

/// A triangle whose corners go along straight lines, all in the same time. (3 x 3), metres.
struct MovingTriangle {
  std::array<Eigen::Vector3d, 3> from, to;
};

/// Whether a point that goes straight from one place to another in the time of a triangle's motion goes through that
/// triangle, from either side; also where it leaves it again. The times at which the four lie in a plane are the roots
/// of a cubic (Provot 1997). What begins or ends in the triangle has not gone through.
bool goes_through(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const MovingTriangle& triangle);

}  // namespace thinwall
