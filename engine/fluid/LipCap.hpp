#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>

#include "engine/fluid/PressureLoad.hpp"

namespace thinwall {

/// The cap that closes an opening of a wall: a fan of triangles from the mean of its lips to the edges between them. It
/// moves with the lips, has no stiffness, and no load of its own.
///
/// Lips: (3 x n), metres, around the opening in the sense of the wall's triangles; the cap's own run the other way.
struct LipCap {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  // metres, mean of the lips
  Eigen::Vector3d area = Eigen::Vector3d::Zero();    // metres^2, vector area, out of what the wall encloses
  double volume = 0;                                 // metres^3, between the cap and the origin
  Eigen::Matrix3Xd volume_gradient;                  // (3 x n), metres^2
};
LipCap lip_cap_of(const Eigen::Matrix3Xd& lips);

/// Gradient of the magnitude of the vector area by the lips, (3 x n), metres; zero where there is no area.
Eigen::Matrix3Xd open_area_gradient(const Eigen::Matrix3Xd& lips, const Eigen::Vector3d& area);

/// Integral of x between the cap and the origin, metres^4, and its gradient for each component, (3 x n), metres^3.
struct LipMoment {
  Eigen::Vector3d value;
  std::array<Eigen::Matrix3Xd, 3> gradient;
};
LipMoment lip_moment_of(const Eigen::Matrix3Xd& lips);

/// Sum over the triangles of the fan of what `of_triangle` gives for the corners of each, (x0, y0, z0, x1, ..., z2),
/// as parts of the lips, (3 x n); what the middle of the fan gets is shared by all.
Eigen::Matrix3Xd lip_sum_of(
    const Eigen::Matrix3Xd& lips,
    const std::function<Eigen::Matrix<double, 9, 1>(const std::array<Eigen::Vector3d, 3>&)>& of_triangle);

/// Load that the pressure would have on the cap, as forces on the lips, (3 x n), newton. The load of the same pressure
/// on the wall alone is the one on wall and cap less this.
Eigen::Matrix3Xd lip_load_of(const Eigen::Matrix3Xd& lips, const PressureField& field);

}  // namespace thinwall
