#pragma once

#include <Eigen/Core>
#include <array>

namespace thinwall {

/// The smooth potential that keeps the wall outside a tool. Per area of rest surface, as a function of the gap g:
/// with s = g / range, pressure p(s) = stiffness (1 - s)^2 for 0 <= s < 1, stiffness (1 - 2 s) for s < 0, 0 for s >= 1.
/// Pressure and its slope are continuous; below zero the pressure is linear, so that a tool that has moved far into
/// the wall is left in one Newton step. With pressures of some per cent of `stiffness` the wall rests at a gap of
/// nearly `range`.
struct ContactPotential {
  double range = 1e-6;   // metres
  double stiffness = 1;  // pascal

  double energy(double gap) const;          // joule / metre^2
  double pressure(double gap) const;        // pascal, minus the derivative of the energy
  double pressure_slope(double gap) const;  // pascal / metre, derivative of the pressure, never positive
};

struct SphereTool {
  Eigen::Vector3d center;  // metres
  double radius;           // metres
};

/// What a sphere does to one wall triangle.
struct SphereContactTerms {
  bool touched = false;                  // whether any sample lies within the range; if not, all else is zero
  double energy = 0;                     // joule
  Eigen::Matrix<double, 9, 1> gradient;  // newton
  Eigen::Matrix<double, 9, 9> hessian;   // newton / metre
  Eigen::Vector3d tool_force;            // newton, what the tissue does to the tool
  double pressed = 0;                    // newton, sum of pressure times area
  double pressed_squared = 0;            // pascal newton, sum of squared pressure times area
};

/// Energy of the samples of a triangle: its rest area is divided into `divisions`^2 equal parts and the potential is
/// taken at the centroid of each, so that the contact depends on the tool and not on the mesh.
SphereContactTerms sphere_contact_terms(const SphereTool& sphere, const ContactPotential& potential, double rest_area,
                                        int divisions, const std::array<Eigen::Vector3d, 3>& corners);

}  // namespace thinwall
