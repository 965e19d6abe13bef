#pragma once

#include <Eigen/Core>
#include <array>

#include "engine/material/WallLaw.hpp"
#include "engine/wall/Prestretch.hpp"

namespace thinwall {

/// The stress-free shape of a linear membrane triangle.
struct MembraneRest {
  Eigen::Matrix2d inverse_edges;  // inverse of the rest edge matrix [X1 - X0, X2 - X0] in the rest plane, 1 / metre
  double area;                    // metres^2, rest
  double thickness;               // metres, rest
};

/// Rest shape of a triangle whose corners are given in the mesh, shrunk by `prestretch`. The first axis of the rest
/// plane lies along `fibre`, brought into the plane of the triangle; along its first edge where that is zero. Asserts a
/// positive area, and that no direction that is asked for stands perpendicular to the triangle.
MembraneRest make_membrane_rest(const std::array<Eigen::Vector3d, 3>& corners, double thickness,
                                const Prestretch& prestretch = {},
                                const Eigen::Vector3d& fibre = Eigen::Vector3d::Zero());

/// What a viscous wall adds to its law during a step: S = scale S_law(C) + overstress + damping D0 e with the law's
/// tangent D0 of the unstrained wall and e = (E11, E22, 2 E12). It has the potential scale W + overstress . e +
/// damping / 2 e . D0 e per rest volume.
struct MembraneMemory {
  double scale = 1;                                      // part of the law's stress that acts at once
  Eigen::Vector3d overstress = Eigen::Vector3d::Zero();  // pascal, (S11, S22, S12)
  double damping = 0;                                    // a number
  bool tension_field = false;                            // the law's answer is relaxed, see TensionField.hpp
  double slack_stiffness = 0;                            // of a relaxed one, see TensionField.hpp
};

/// What a triangle of the wall answers for C = (C11, C22, C12).
struct MembraneResponse {
  WallLawResponse whole;  // memory included
  double strain_energy;   // joule / metre^3, of the wall law alone
};
MembraneResponse membrane_response(const Material& material, const Eigen::Vector3d& right_cauchy_green,
                                   const MembraneMemory& memory);

/// Energy of a triangle and its derivatives with respect to the corners (x0, y0, z0, x1, ..., z2).
struct MembraneTerms {
  double energy;                         // joule
  double strain_energy;                  // joule, of the wall law alone
  Eigen::Matrix<double, 9, 1> gradient;  // newton
  Eigen::Matrix<double, 9, 9> hessian;   // newton / metre, symmetric
};

/// Total Lagrangian membrane triangle: deformation gradient F = [x1 - x0, x2 - x0] Dm^-1 (3 x 2), C = F^T F,
/// energy A0 h W(C); gradient A0 h F S grad N; Hessian from the tangent dS/dE and the geometric term of S
/// (Bonet and Wood 2008, chapters 8 and 9). Of many triangles see MembraneLanes.hpp.
MembraneTerms membrane_terms(const MembraneRest& rest, const Material& material,
                             const std::array<Eigen::Vector3d, 3>& corners, const MembraneMemory& memory = {});

/// Second Piola-Kirchhoff stress (S11, S22, S12) at the corners, pascal, and what it would become with the strain that
/// a motion of the corners adds in first order. Asserts nothing about how far the motion goes.
struct MembraneStress {
  Eigen::Vector3d now;
  Eigen::Vector3d foreseen;
};
MembraneStress membrane_stress(const MembraneRest& rest, const Material& material,
                               const std::array<Eigen::Vector3d, 3>& corners,
                               const std::array<Eigen::Vector3d, 3>& motion, const MembraneMemory& memory = {});

/// The part of the Hessian that a stress makes by itself, (S11, S22, S12), pascal.
Eigen::Matrix<double, 9, 9> geometric_stiffness(const MembraneRest& rest, const Eigen::Vector3d& stress);

/// Green-Lagrange strain e = (E11, E22, 2 E12) in the rest plane.
Eigen::Vector3d green_lagrange_strain(const MembraneRest& rest, const std::array<Eigen::Vector3d, 3>& corners);

/// Deformation gradient (3 x 2) from the rest plane to space.
Eigen::Matrix<double, 3, 2> deformation_gradient(const MembraneRest& rest,
                                                 const std::array<Eigen::Vector3d, 3>& corners);

/// Principal Cauchy stresses in the wall's plane, the larger first, pascal: the eigenvalues of F S F^T, which are those
/// of S C. `stress`: the second Piola-Kirchhoff stress (S11, S22, S12), pascal, `right_cauchy_green`: (C11, C22, C12).
/// The wall keeps its volume.
Eigen::Vector2d principal_cauchy_stress(const Eigen::Vector3d& stress, const Eigen::Vector3d& right_cauchy_green);

/// Tension of the wall: the larger principal value of the Cauchy stress integrated over the current thickness,
/// newton / metre: h (F S F^T) / sqrt(det C).
double largest_tension(const MembraneRest& rest, const Material& material,
                       const std::array<Eigen::Vector3d, 3>& corners);

}  // namespace thinwall
