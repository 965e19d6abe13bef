#include "engine/solver/BorderedSystem.hpp"

#include <Eigen/Eigenvalues>

namespace thinwall {

void BorderedSystem::set(SparseFactor& factor, int negative_pivots, const Eigen::MatrixXd& border,
                         const Eigen::MatrixXd& corner) {
  negative_eigenvalues_ = negative_pivots;
  border_ = border;
  if (border.cols() == 0) return;
  solved_border_ = border;
  factor.solve(solved_border_);
  const Eigen::MatrixXd schur = corner - border.transpose() * solved_border_;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(0.5 * (schur + schur.transpose()));
  Eigen::VectorXd inverse = spectrum.eigenvalues();
  for (double& value : inverse) {
    negative_eigenvalues_ += value < 0 ? 1 : 0;
    value = 1 / value;
  }
  schur_inverse_ = spectrum.eigenvectors() * inverse.asDiagonal() * spectrum.eigenvectors().transpose();
}

void BorderedSystem::solve(SparseFactor& factor, Eigen::VectorXd& f, Eigen::VectorXd& g) const {
  factor.solve(f);
  if (border_.cols() == 0) return;
  g = schur_inverse_ * (g - border_.transpose() * f);
  f -= solved_border_ * g;
}

}  // namespace thinwall
