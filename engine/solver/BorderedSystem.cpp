#include "engine/solver/BorderedSystem.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <utility>
#include <vector>

namespace thinwall {

void BorderedSystem::expect(Eigen::VectorXd f) {
  expected_ = std::move(f);
  solved_expected_.resize(0);
}

/// K^-1 of both into `solved_border_` and `solved_columns_`.
void BorderedSystem::solve_together(SparseFactor& factor, const Eigen::MatrixXd& border,
                                    const Eigen::MatrixXd& columns) {
  std::vector<Eigen::Index> filled;  // columns of the border that are not zero, as those of chambers with air are
  for (Eigen::Index k = 0; k < border.cols(); ++k) {
    if (!border.col(k).isZero(0)) filled.push_back(k);
  }
  const auto own = static_cast<Eigen::Index>(filled.size()), all = own + columns.cols();
  const bool is_expected = expected_.size() > 0 && solved_expected_.size() == 0;
  const bool takes_expected =
      is_expected && SparseFactor::cost_of(all + 1) < SparseFactor::cost_of(all) + SparseFactor::cost_of(1);
  solved_both_.resize(border.rows(), all + (takes_expected ? 1 : 0));
  for (Eigen::Index k = 0; k < own; ++k) solved_both_.col(k) = border.col(filled[k]);
  solved_both_.middleCols(own, columns.cols()) = columns;
  if (takes_expected) solved_both_.col(all) = expected_;
  if (solved_both_.cols() > 0) factor.solve(solved_both_);
  solved_border_.setZero(border.rows(), border.cols());
  for (Eigen::Index k = 0; k < own; ++k) solved_border_.col(filled[k]) = solved_both_.col(k);
  solved_columns_ = solved_both_.middleCols(own, columns.cols());
  if (takes_expected) {
    solved_expected_ = solved_both_.col(all);
  } else {
    expect({});
  }
}

void BorderedSystem::set(SparseFactor& factor, int negative_pivots, const Eigen::MatrixXd& border,
                         const Eigen::MatrixXd& corner) {
  solve_together(factor, border, Eigen::MatrixXd(border.rows(), 0));
  std::swap(solved_border_, solved_columns_);
  rows_ = border;
  is_unsymmetric_ = false;
  eliminate(negative_pivots, border, solved_columns_, corner);
}

void BorderedSystem::set_solved(int negative_pivots, const Eigen::MatrixXd& border,
                                const Eigen::Ref<const Eigen::MatrixXd>& solved, const Eigen::MatrixXd& corner) {
  solved_columns_ = solved;
  rows_ = border;
  is_unsymmetric_ = false;
  eliminate(negative_pivots, border, solved_columns_, corner);
}

void BorderedSystem::set_unsymmetric(SparseFactor& factor, int negative_pivots, const Eigen::MatrixXd& border,
                                     const Eigen::MatrixXd& columns, const Eigen::MatrixXd& rows,
                                     const Eigen::MatrixXd& corner) {
  solve_together(factor, border, columns);
  border_ = border;
  rows_ = rows;
  is_unsymmetric_ = true;
  eliminate(negative_pivots, border, solved_border_, corner);
  if (rows.cols() > 0) schur_inverse_ = (corner - rows.transpose() * solved_columns_).partialPivLu().inverse();
}

void BorderedSystem::eliminate(int negative_pivots, const Eigen::MatrixXd& border, const Eigen::MatrixXd& solved,
                               const Eigen::MatrixXd& corner) {
  negative_eigenvalues_ = negative_pivots;
  if (border.cols() == 0) return;
  const Eigen::MatrixXd schur = corner - border.transpose() * solved;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(0.5 * (schur + schur.transpose()));
  Eigen::VectorXd inverse = spectrum.eigenvalues();
  for (double& value : inverse) {
    negative_eigenvalues_ += value < 0 ? 1 : 0;
    value = 1 / value;
  }
  schur_inverse_ = spectrum.eigenvectors() * inverse.asDiagonal() * spectrum.eigenvectors().transpose();
}

void BorderedSystem::solve(SparseFactor& factor, Eigen::VectorXd& f, Eigen::VectorXd& g) const {
  if (solved_expected_.size() > 0 && f == expected_) {
    f = solved_expected_;
  } else {
    factor.solve(f);
  }
  if (rows_.cols() == 0) return;
  g = schur_inverse_ * (g - rows_.transpose() * f);
  f -= solved_columns_ * g;
}

}  // namespace thinwall
