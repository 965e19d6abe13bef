#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/solver/BorderedSystem.hpp"
#include "engine/solver/SparseFactor.hpp"

namespace thinwall {

/// A bordered system for right-hand sides that are zero but at some of its unknowns, and for solutions that are wanted
/// there alone: with C^T K^-1 f = (K^-1 C)^T f only the fronts of these unknowns and those above them are asked for.
class BorderedPart {
 public:
  /// Both must stay as they are while this is in use. The two sides of the border may differ at `unknowns` only.
  BorderedPart(SparseFactor& factor, const BorderedSystem& whole, std::vector<int> unknowns);

  /// x of the right-hand side (f, 0). (unknowns of the part) each.
  Eigen::VectorXd solve(const Eigen::VectorXd& f) const;

 private:
  SparseFactor& factor_;
  SparseFactor::Part part_;
  Eigen::MatrixXd solved_columns_;  // (unknowns of the part x columns), K^-1 B
  Eigen::MatrixXd solved_rows_;     // (unknowns of the part x columns), K^-1 C
  Eigen::MatrixXd schur_inverse_;
};

}  // namespace thinwall
