#pragma once

#include <Eigen/Core>

#include "engine/solver/SparseFactor.hpp"

namespace thinwall {

/// Solves the symmetric bordered system
///
///     | K    B | | x |   | f |
///     | B^T  D | | y | = | g |
///
/// with a sparse K that is factorised and a few dense columns B (fluid pressures, rigid motions), by the Schur
/// complement S = D - B^T K^-1 B. Sylvester's law gives the inertia of the whole: that of K plus that of S.
class BorderedSystem {
 public:
  /// B is (unknowns x columns), D (columns x columns). `negative_pivots` is the inertia of the factor.
  void set(SparseFactor& factor, int negative_pivots, const Eigen::MatrixXd& border, const Eigen::MatrixXd& corner);

  /// Number of negative eigenvalues of the whole matrix.
  int negative_eigenvalues() const { return negative_eigenvalues_; }

  /// f and g are replaced by x and y.
  void solve(SparseFactor& factor, Eigen::VectorXd& f, Eigen::VectorXd& g) const;

 private:
  Eigen::MatrixXd border_;
  Eigen::MatrixXd solved_border_;  // K^-1 B
  Eigen::MatrixXd schur_inverse_;  // S^-1
  int negative_eigenvalues_ = 0;
};

}  // namespace thinwall
