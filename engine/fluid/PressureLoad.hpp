#pragma once

#include <Eigen/Core>
#include <array>

namespace thinwall {

/// A pressure that changes evenly in space, as that of a fluid at rest or evenly accelerated.
struct PressureField {
  double at_origin = 0;                             // pascal
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();  // pascal / metre
  bool suction = true;                              // otherwise zero where it would be less: above a free surface

  double at(const Eigen::Vector3d& point) const {
    const double even = at_origin + slope.dot(point);
    return suction || even > 0 ? even : 0;
  }
};

/// The moments J_ab of a triangle with these pressures at its corners, pascal: the integrals of the products of two
/// shape functions over twice the area. Without `suction` over the part where the pressure counts, which is cut off in
/// barycentric coordinates and taken as a fan of triangles.
Eigen::Matrix3d pressed_moments(const Eigen::Vector3d& pressures, bool suction);

/// A pressure on one side of an oriented triangle, along its normal, and what its loads have in common: with the normal
/// n = (x1 - x0) x (x2 - x0) the moments J_ab over the part that is not above a free surface; of the whole
/// (1 + delta_ab) / 24. Loads are at the corners, (x0, y0, z0, x1, ..., z2).
class PressedTriangle {
 public:
  PressedTriangle(const std::array<Eigen::Vector3d, 3>& corners, const PressureField& field);

  /// Newton: f_a = n sum_b J_ab p_b. Over a closed surface of enclosed volume V and first moment M it is the gradient
  /// of at_origin V + slope . M of what is filled; it makes sense on an open one too, which the gradients of the parts
  /// of V and M that a triangle has with the origin do not.
  Eigen::Matrix<double, 9, 1> load() const;

  /// Its derivative by `at_origin`, metres^2.
  Eigen::Matrix<double, 9, 1> unit_load() const;

  /// What the triangle adds to the integral of n p^2 / 2, (metres^2 pascal^2). Over a closed surface the sum is the
  /// integral of p over what is filled, times the slope.
  Eigen::Vector3d squared_load() const;

  /// The symmetric part of the load's derivative by the corners, newton / metre. Over a closed surface it is the whole;
  /// over an open one what is missing lies on the rim, see `rim_load_change`.
  Eigen::Matrix<double, 9, 9> symmetric_tangent() const;

 private:
  Eigen::Vector3d normal_;                // metres^2, of twice the area
  std::array<Eigen::Vector3d, 3> edges_;  // metres, opposite to the corners
  Eigen::Vector3d slope_;                 // pascal / metre
  Eigen::Vector3d pressures_;             // pascal, at the corners
  Eigen::Matrix3d moments_;               // J
  Eigen::Vector3d shares_;                // pascal, J p
};

inline Eigen::Matrix<double, 9, 1> pressure_load_of(const std::array<Eigen::Vector3d, 3>& corners,
                                                    const PressureField& field) {
  return PressedTriangle(corners, field).load();
}

/// The loads of three pressures of a pascal per metre from the origin along x, y and z, in columns, newton.
Eigen::Matrix<double, 9, 3> moment_loads_of(const std::array<Eigen::Vector3d, 3>& corners);

/// What the skew-symmetric part of the load's derivative, summed over a surface, gives at the two ends of an edge of
/// its rim when these move: f_a = -1/2 e x sum_b u_b (integral of N_a N_b p), with e from the first to the second in
/// the sense of the surface's triangles (from the theorem of Stokes for 1/2 p u x v along the rim). Newton.
std::array<Eigen::Vector3d, 2> rim_load_change(const std::array<Eigen::Vector3d, 2>& ends,
                                               const std::array<Eigen::Vector3d, 2>& motion,
                                               const PressureField& field);

}  // namespace thinwall
