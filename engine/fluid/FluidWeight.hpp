#pragma once

#include <Eigen/Core>
#include <array>

#include "engine/solver/Lanes.hpp"

namespace thinwall {

/// Integral of g . x over the tetrahedron of the origin and an oriented triangle, with its derivative. Over a closed
/// surface the sum is the integral over what it encloses; minus density times it is the fluid's energy in gravity g,
/// and its gradient is the load of the hydrostatic pressure density g . x.
struct FluidMoment {
  double value;                          // g's unit times metre^4
  Eigen::Matrix<double, 9, 1> gradient;  // g's unit times metre^3, by the corners (x0, y0, z0, x1, ..., z2)
};
FluidMoment fluid_moment_of(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& gravity);
/// Its second derivatives, symmetric, g's unit times metre^2.
Eigen::Matrix<double, 9, 9> fluid_moment_hessian(const std::array<Eigen::Vector3d, 3>& corners,
                                                 const Eigen::Vector3d& gravity);
/// Its value alone, g's unit times metre^4.
double fluid_moment_value(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& gravity);

/// The same integral of x itself, without second derivatives.
struct FirstMoment {
  Eigen::Vector3d value;                 // metres^4
  Eigen::Matrix<double, 9, 3> gradient;  // metres^3, of each component by the corners
};
FirstMoment first_moment_of(const std::array<Eigen::Vector3d, 3>& corners);

/// The same of as many triangles as there are lanes, equal to the bit. `corners`: (9 x lanes), metres, x0, y0, z0, x1,
/// ..., z2.
struct FirstMoments {
  double value[3][kLanes];        // metres^4
  double gradient[3][9][kLanes];  // metres^3, of each component by the corners
};
void first_moments_of(const double (&corners)[9][kLanes], FirstMoments& moments);

}  // namespace thinwall
