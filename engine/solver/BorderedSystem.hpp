#pragma once

#include <Eigen/Core>

#include "engine/solver/SparseFactor.hpp"

namespace thinwall {

/// Solves the bordered system
///
///     | K    B | | x |   | f |
///     | C^T  D | | y | = | g |
///
/// with a sparse symmetric K that is factorised and a few dense columns B and C (fluid pressures, rigid motions), by
/// the Schur complement S = D - C^T K^-1 B. Where C is B and D symmetric, Sylvester's law gives the inertia of the
/// whole: that of K plus that of S. With a factor in single precision K^-1 B stays as it is solved, and solutions may
/// be refined: what is left of both sides, in double precision, is solved for again.
class BorderedSystem {
 public:
  /// Says which f is going to be solved for after the next `set`, (unknowns): it is solved along with the border, with
  /// other last bits than alone, where that costs less or the factor is in single precision.
  void expect(Eigen::VectorXd f);

  /// C is B. B is (unknowns x columns), D (columns x columns). `negative_pivots` is the inertia of the factor.
  void set(SparseFactor& factor, int negative_pivots, const Eigen::MatrixXd& border, const Eigen::MatrixXd& corner);

  /// The same where K^-1 B is known already, (unknowns x columns).
  void set_solved(int negative_pivots, const Eigen::MatrixXd& border, const Eigen::Ref<const Eigen::MatrixXd>& solved,
                  const Eigen::MatrixXd& corner);

  /// B and C that differ, `columns` and `rows`; the inertia is that with `border` on either side. Border and columns
  /// are solved for together.
  void set_unsymmetric(SparseFactor& factor, int negative_pivots, const Eigen::MatrixXd& border,
                       const Eigen::MatrixXd& columns, const Eigen::MatrixXd& rows, const Eigen::MatrixXd& corner);

  /// K^-1 B, (unknowns x columns).
  const Eigen::MatrixXd& solved_columns() const { return solved_columns_; }

  /// The sides of the border, (unknowns x columns): the one that the inertia is of, and C; with K^-1 of the former.
  const Eigen::MatrixXd& border() const { return is_unsymmetric_ ? border_ : rows_; }
  const Eigen::MatrixXd& rows() const { return rows_; }
  const Eigen::MatrixXd& solved_border() const { return is_unsymmetric_ ? solved_border_ : solved_columns_; }
  /// (D - C^T K^-1 B)^-1, (columns x columns).
  const Eigen::MatrixXd& schur_inverse() const { return schur_inverse_; }

  /// Number of negative eigenvalues of the whole matrix.
  int negative_eigenvalues() const { return negative_eigenvalues_; }

  /// f and g are replaced by x and y.
  void solve(SparseFactor& factor, Eigen::VectorXd& f, Eigen::VectorXd& g) const;

  /// With a factor in single precision: solves for what x and y leave of f and g until that is as little as double
  /// precision would leave.
  void refine(SparseFactor& factor, const Eigen::VectorXd& f, const Eigen::VectorXd& g, Eigen::VectorXd& x,
              Eigen::VectorXd& y);

  /// With a factor in single precision the largest part of a right-hand side that was left since the last `set`: of
  /// what is expected as it was solved along with the border, of others once they were refined. Zero in double.
  double missed_part() const { return missed_part_; }

 private:
  void eliminate(int negative_pivots, const Eigen::MatrixXd& border, const Eigen::MatrixXd& solved,
                 const Eigen::MatrixXd& corner);
  void note_missed(SparseFactor& factor);
  void solve_together(SparseFactor& factor, const Eigen::MatrixXd& border, const Eigen::MatrixXd& columns);

  Eigen::MatrixXd rows_;            // C
  Eigen::MatrixXd columns_;         // B, where it is not C
  Eigen::MatrixXd corner_;          // D
  Eigen::MatrixXd solved_columns_;  // K^-1 B
  Eigen::MatrixXd schur_inverse_;   // S^-1
  bool is_unsymmetric_ = false;
  Eigen::MatrixXd border_;           // the one that the inertia is of, where they differ
  Eigen::MatrixXd solved_border_;    // K^-1 of it
  Eigen::MatrixXd solved_both_;      // K^-1 of what is no zero of it, of B and of what is expected
  Eigen::VectorXd expected_;         // f that is going to be solved for, or none
  Eigen::VectorXd solved_expected_;  // K^-1 of it, where it was solved along
  int negative_eigenvalues_ = 0;
  double missed_part_ = 0;
};

}  // namespace thinwall
