#include "engine/solver/BorderedSystem.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <utility>
#include <vector>

#include "engine/solver/InnerProducts.hpp"

namespace thinwall {
namespace {

/// Part of a right-hand side that a refined solution may miss, and turns that are worth their time: on the matrices of
/// membranes with inertia the first solution misses up to 1e-3, and each turn leaves some 1e-4 of that.
constexpr double kMissedPart = 1e-10;
constexpr int kRefinements = 3;

}  // namespace

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
      is_expected && (factor.precision() == Precision::kSingle ||
                      SparseFactor::cost_of(all + 1) < SparseFactor::cost_of(all) + SparseFactor::cost_of(1));
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
    note_missed(factor);
  } else {
    expect({});
  }
}

void BorderedSystem::note_missed(SparseFactor& factor) {
  if (factor.precision() == Precision::kDouble || expected_.isZero(0)) return;
  Eigen::VectorXd left = expected_;
  factor.subtract_product(solved_expected_, left);
  missed_part_ = left.norm() / expected_.norm();
}

void BorderedSystem::set(SparseFactor& factor, int negative_pivots, const Eigen::MatrixXd& border,
                         const Eigen::MatrixXd& corner) {
  missed_part_ = 0;
  solve_together(factor, border, Eigen::MatrixXd(border.rows(), 0));
  std::swap(solved_border_, solved_columns_);
  rows_ = border;
  is_unsymmetric_ = false;
  eliminate(negative_pivots, border, solved_columns_, corner);
}

void BorderedSystem::set_solved(int negative_pivots, const Eigen::MatrixXd& border,
                                const Eigen::Ref<const Eigen::MatrixXd>& solved, const Eigen::MatrixXd& corner) {
  missed_part_ = 0;
  solved_columns_ = solved;
  rows_ = border;
  is_unsymmetric_ = false;
  eliminate(negative_pivots, border, solved_columns_, corner);
}

void BorderedSystem::set_unsymmetric(SparseFactor& factor, int negative_pivots, const Eigen::MatrixXd& border,
                                     const Eigen::MatrixXd& columns, const Eigen::MatrixXd& rows,
                                     const Eigen::MatrixXd& corner) {
  missed_part_ = 0;
  solve_together(factor, border, columns);
  border_ = border;
  columns_ = columns;
  rows_ = rows;
  is_unsymmetric_ = true;
  eliminate(negative_pivots, border, solved_border_, corner);
  if (rows.cols() > 0) schur_inverse_ = (corner - inner_products(rows, solved_columns_)).partialPivLu().inverse();
}

void BorderedSystem::eliminate(int negative_pivots, const Eigen::MatrixXd& border, const Eigen::MatrixXd& solved,
                               const Eigen::MatrixXd& corner) {
  corner_ = corner;
  negative_eigenvalues_ = negative_pivots;
  if (border.cols() == 0) return;
  const Eigen::MatrixXd schur = corner - inner_products(border, solved);
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

void BorderedSystem::refine(SparseFactor& factor, const Eigen::VectorXd& f, const Eigen::VectorXd& g,
                            Eigen::VectorXd& x, Eigen::VectorXd& y) {
  if (factor.precision() == Precision::kDouble) return;
  const Eigen::MatrixXd& columns = is_unsymmetric_ ? columns_ : rows_;
  for (int turn = 0;; ++turn) {
    Eigen::VectorXd left = f, left_border = g;
    double scale = f.norm();
    if (rows_.cols() > 0) {
      const Eigen::VectorXd of_border = columns * y;
      scale = std::max(scale, of_border.norm());
      left -= of_border;
      left_border -= rows_.transpose() * x + corner_ * y;
    }
    factor.subtract_product(x, left);
    const double missed = scale > 0 ? left.norm() / scale : 0;
    if (missed <= kMissedPart) return;
    if (turn == kRefinements) {
      missed_part_ = missed <= missed_part_ ? missed_part_ : missed;  // what is no number too
      return;
    }
    solve(factor, left, left_border);
    x += left;
    y += left_border;
  }
}

}  // namespace thinwall
