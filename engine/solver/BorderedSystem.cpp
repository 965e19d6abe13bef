#include "engine/solver/BorderedSystem.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <utility>

namespace thinwall {

void BorderedSystem::set(SparseFactor& factor, int negative_pivots, const Eigen::MatrixXd& border,
                         const Eigen::MatrixXd& corner) {
  negative_eigenvalues_ = negative_pivots;
  solved_columns_ = border;
  if (border.cols() > 0) factor.solve(solved_columns_);
  eliminate(border, corner);
}

void BorderedSystem::set_solved(int negative_pivots, const Eigen::MatrixXd& border,
                                const Eigen::Ref<const Eigen::MatrixXd>& solved, const Eigen::MatrixXd& corner) {
  negative_eigenvalues_ = negative_pivots;
  solved_columns_ = solved;
  eliminate(border, corner);
}

void BorderedSystem::eliminate(const Eigen::MatrixXd& border, const Eigen::MatrixXd& corner) {
  rows_ = border;
  is_unsymmetric_ = false;
  if (border.cols() == 0) return;
  const Eigen::MatrixXd schur = corner - border.transpose() * solved_columns_;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(0.5 * (schur + schur.transpose()));
  Eigen::VectorXd inverse = spectrum.eigenvalues();
  for (double& value : inverse) {
    negative_eigenvalues_ += value < 0 ? 1 : 0;
    value = 1 / value;
  }
  schur_inverse_ = spectrum.eigenvectors() * inverse.asDiagonal() * spectrum.eigenvectors().transpose();
}

void BorderedSystem::set_unsymmetric(SparseFactor& factor, int negative_pivots, const Eigen::MatrixXd& border,
                                     const Eigen::MatrixXd& columns, const Eigen::MatrixXd& rows,
                                     const Eigen::MatrixXd& corner) {
  solved_both_.resize(border.rows(), border.cols() + columns.cols());
  solved_both_ << border, columns;
  if (solved_both_.cols() > 0) factor.solve(solved_both_);
  set_solved(negative_pivots, border, solved_both_.leftCols(border.cols()), corner);
  std::swap(border_, rows_);
  std::swap(solved_border_, solved_columns_);
  is_unsymmetric_ = true;
  rows_ = rows;
  solved_columns_ = solved_both_.rightCols(columns.cols());
  if (rows.cols() == 0) return;
  schur_inverse_ = (corner - rows.transpose() * solved_columns_).partialPivLu().inverse();
}

void BorderedSystem::solve(SparseFactor& factor, Eigen::VectorXd& f, Eigen::VectorXd& g) const {
  factor.solve(f);
  if (rows_.cols() == 0) return;
  g = schur_inverse_ * (g - rows_.transpose() * f);
  f -= solved_columns_ * g;
}

}  // namespace thinwall
