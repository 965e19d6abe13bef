#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "engine/solver/BlockPattern.hpp"
#include "engine/solver/DenseAddresses.hpp"
#include "engine/solver/SparseFactor.hpp"

namespace thinwall {

/// Compressible neo-Hookean material: W = mu/2 (tr C - 3) - mu ln J + lambda/2 (ln J)^2.
struct SolidMaterial {
  double mu = 0, lambda = 0;  // pascal
};

/// A solid half ball of linear tetrahedra, for comparison with the membrane on its surface: as many copies of that
/// surface, shrunk towards the centre of the base, as make the elements as deep as they are wide.
struct TetrahedralMesh {
  std::vector<Eigen::Vector3d> vertices;       // (vertices), metres
  std::vector<std::array<int, 4>> tetrahedra;  // of positive volume
  int crown = 0;                               // vertex
  std::vector<char> fixed;                     // (vertices), on the base
};

/// On a hemisphere of 4 n^2 triangles with 2 n layers: n = 4 has 8 x 41 = 328 vertices.
TetrahedralMesh make_half_ball(double radius, int n);

/// The tetrahedra with all that a solution needs, analysed once.
class TetrahedralSolid {
 public:
  TetrahedralSolid(TetrahedralMesh mesh, SolidMaterial material);

  /// Gradient of the energy, newton, and the Hessian's values, newton / metre, at a position, (unknowns), metres; false
  /// where an element is turned inside out.
  bool assemble(const Eigen::VectorXd& position);

  /// Presses the crown to a height above the base, metres, and finds the equilibrium by Newton's method to a residual
  /// of `tolerance` times the largest force of an element. Gives the iterations, or -1 where it finds none.
  int press(double height, double tolerance);

  /// Factorises the Hessian as assembled, with fixed unknowns held.
  bool factorize();

  /// What the solid does to the crown, newton.
  Eigen::Vector3d crown_force() const { return -gradient_.segment<3>(3 * mesh_.crown); }

  const Eigen::VectorXd& position() const { return position_; }
  const TetrahedralMesh& mesh() const { return mesh_; }
  const BlockPattern& pattern() const { return pattern_; }
  const SparseFactor& factor() const { return factor_; }

 private:
  struct Element {
    std::array<int, 12> unknowns;
    Eigen::Matrix<double, 4, 3> shape;  // 1 / metre, gradients of the shape functions
    double volume = 0;                  // metres^3
    DenseAddresses<12> addresses;
  };

  TetrahedralMesh mesh_;
  SolidMaterial material_;
  BlockPattern pattern_;
  std::vector<Element> elements_;
  std::vector<char> held_;  // (unknowns)
  SparseFactor factor_;
  Eigen::VectorXd position_, gradient_;
  std::vector<double> values_, held_values_;
  double largest_force_ = 0;  // newton
};

}  // namespace thinwall
