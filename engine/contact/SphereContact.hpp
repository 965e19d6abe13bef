#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

namespace thinwall {

/// The potential that keeps a triangle outside a tool, as a function of the gap g between the two: the force rises
/// evenly from 0 at g = range to `largest` at g = 0 and beyond. With forces of some per cent of `largest` the wall
/// rests at a gap of nearly `range`. An even rise makes a contact a linear spring, so that Newton's method only has to
/// find out which triangles touch.
struct ContactPotential {
  double range = 1e-6;  // metres
  double largest = 1;   // newton, the force at which the gap closes

  double stiffness() const { return largest / range; }  // newton / metre
  double energy(double gap) const;                      // joule
};

struct SphereTool {
  Eigen::Vector3d center;  // metres
  double radius;           // metres
};

/// The gap between a sphere and a triangle, and its derivatives by the corners (x0, y0, z0, x1, ..., z2).
struct SphereGap {
  double gap = 0;                        // metres
  Eigen::Vector3d normal;                // unit, from the sphere's centre to the closest point
  Eigen::Matrix<double, 9, 1> gradient;  // a number
  Eigen::Matrix<double, 9, 9> hessian;   // 1 / metre
};

/// The gap to the point of the triangle closest to the sphere's centre, or nothing when it exceeds `reach`, metres.
/// The closest point may lie on the face, an edge or a corner; it moves as the triangle does, so that a flat face may
/// slide and roll on the sphere without resistance, and the wall as a whole stays outside, not its vertices only.
/// With the closest point at weights w, u from the centre to it and T the edges (columns) that it may move along, the
/// gradient of half the squared distance by corner a is w_a u, its Hessian w_a w_b 1 - G_a^T (T^T T)^-1 G_b with
/// G_a = w_a T^T + d_a u^T, d_a the derivative of T^T by corner a (the minimum over w, differentiated twice).
std::optional<SphereGap> sphere_gap(const SphereTool& sphere, double reach,
                                    const std::array<Eigen::Vector3d, 3>& corners);

}  // namespace thinwall
