#pragma once

#include <Eigen/Core>
#include <array>
#include <numbers>

namespace thinwall {

/// What the bending of a triangle depends on.
struct BendingPatch {
  std::array<Eigen::Vector3d, 6> position;          // metres: its corners, and the far corners of its three neighbours
  Eigen::Vector3d turns = Eigen::Vector3d::Zero();  // metres: unknowns of its sides, angles times a length
};

/// A side of a triangle in bending: how far the wall's normal there has turned from the triangle's, about the side,
/// is `share` of the angle between the triangle and what lies beyond, as a fold counts it, plus `turn_share` times the
/// side's own unknown.
struct BendingSide {
  double share = 0;       // 1/2 of the angle to a neighbour, 1 of that to the held plane of a clamped side, else 0
  double turn_share = 0;  // 1 / metre; of contrary sign in the two triangles at a side; 0 where it is clamped
  bool clamped = false;
  Eigen::Vector3d held = Eigen::Vector3d::Zero();  // metres, outwards in the held plane
  double rest_angle = 0;                           // radian, in the stress-free shape
  double fold = std::numbers::pi;                  // radian, angle to what lies beyond from which on more is counted
};

/// A triangle of a thin shell, with one rotation for each side as its only unknown beside the positions. The normal of
/// the wall at the middle of a side is common to both triangles; it lies between theirs, off the bisector by the side's
/// own angle. With theta the turn of that normal against the triangle's, the curvature is the mean of the change of
/// the normal (divergence theorem), kappa = 1 / area sum of length theta nu nu^T over the sides with their outer
/// normals nu at rest: for small rotations the element of Morley (1968), which is exact for even curvature and
/// converges on any mesh; for large ones the shape operator of mid-edge normals (Grinspun, Gingold, Reisman and Zorin
/// 2006). Curvature is counted per length at rest and positive where the wall bends towards its normal; a stretch alone
/// leaves it as it is. Free sides bear no moment, because nothing holds their unknown.
struct BendingRest {
  std::array<int, 6> vertices = {};  // a missing neighbour repeats the first
  std::array<int, 3> edges = {};     // of the sides: their unknowns
  std::array<BendingSide, 3> sides;
  Eigen::Matrix3d weights = Eigen::Matrix3d::Zero();  // 1 / metre, curvature (11, 22, 2 12) by the angles of the sides
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();  // newton metre
  double area = 0;                                      // metres^2, rest
};

/// What a viscous shell adds during a step: moment = scale stiffness (kappa - kappa0) + overmoment.
struct BendingMemory {
  double scale = 1;
  Eigen::Vector3d overmoment = Eigen::Vector3d::Zero();  // newton
};

/// Energy area (scale / 2 (kappa - kappa0) . stiffness (kappa - kappa0) + overmoment . (kappa - kappa0)) and its
/// derivatives by the patch (x0, y0, z0, x1, ..., z5, turns).
struct BendingTerms {
  double energy;                          // joule
  double bending_energy;                  // joule, of the stiffness alone
  Eigen::Matrix<double, 21, 1> gradient;  // newton
  Eigen::Matrix<double, 21, 21> hessian;  // newton / metre, symmetric
};
BendingTerms bending_terms(const BendingRest& rest, const BendingPatch& patch, const BendingMemory& memory = {});

/// Curvature less that of the stress-free shape, (kappa11, kappa22, 2 kappa12), 1 / metre.
Eigen::Vector3d bending_strain(const BendingRest& rest, const BendingPatch& patch);

/// Angles by which the wall's normal at the sides has turned from the triangle's, radian.
Eigen::Vector3d side_angles(const BendingRest& rest, const BendingPatch& patch);

}  // namespace thinwall
