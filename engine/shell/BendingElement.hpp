#pragma once

#include <Eigen/Core>
#include <array>

namespace thinwall {

/// What the bending of a triangle depends on: its corners, and the far corners of its three neighbours.
using BendingPatch = std::array<Eigen::Vector3d, 6>;  // metres

/// A triangle of a thin shell without rotational unknowns. With x(X) the position over the rest plane and t the unit
/// normal of the triangle, the curvature is kappa = t . d2x/dX2, as (kappa11, kappa22, 2 kappa12), 1 / metre. The mean
/// of d2x/dX2 over the triangle follows from the first derivatives at the middle of its sides (divergence theorem),
/// each interpolated between the two triangles at the side (Onate and Zarate 2000, Flores and Onate 2001), here in
/// proportion to the distances of their centroids from it: that makes curvature exact on strips of unequal elements,
/// and since both triangles see one derivative, moments balance across a side on any mesh.
struct BendingRest {
  std::array<int, 6> vertices = {};                     // a missing neighbour repeats the first, with no share
  Eigen::Matrix<double, 3, 6> shares;                   // 1 / metre^2, of the vertices in d2x/dX2
  Eigen::Matrix3d held = Eigen::Matrix3d::Zero();       // 1 / metre, column k: what clamped sides add to d2x/dX2
  Eigen::Vector3d curvature = Eigen::Vector3d::Zero();  // 1 / metre, of the stress-free shape
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();  // newton metre
  double area = 0;                                      // metres^2, rest
};

/// What a viscous shell adds during a step: moment = scale stiffness (kappa - kappa0) + overmoment.
struct BendingMemory {
  double scale = 1;
  Eigen::Vector3d overmoment = Eigen::Vector3d::Zero();  // newton
};

/// Energy area (scale / 2 (kappa - kappa0) . stiffness (kappa - kappa0) + overmoment . (kappa - kappa0)) and its
/// derivatives by the patch (x0, y0, z0, x1, ..., z5).
struct BendingTerms {
  double energy;                          // joule
  double bending_energy;                  // joule, of the stiffness alone
  Eigen::Matrix<double, 18, 1> gradient;  // newton
  Eigen::Matrix<double, 18, 18> hessian;  // newton / metre, symmetric
};
BendingTerms bending_terms(const BendingRest& rest, const BendingPatch& patch, const BendingMemory& memory = {});

/// Curvature less that of the stress-free shape, (kappa11, kappa22, 2 kappa12), 1 / metre.
Eigen::Vector3d bending_strain(const BendingRest& rest, const BendingPatch& patch);

}  // namespace thinwall
