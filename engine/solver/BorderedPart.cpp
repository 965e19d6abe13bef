#include "engine/solver/BorderedPart.hpp"

#include <utility>

namespace thinwall {

BorderedPart::BorderedPart(SparseFactor& factor, const BorderedSystem& whole, std::vector<int> unknowns)
    : factor_(factor),
      part_(factor.part_of(std::move(unknowns))),
      solved_columns_(whole.solved_columns()(part_.unknowns, Eigen::all)),
      solved_rows_(whole.solved_border()(part_.unknowns, Eigen::all)),
      schur_inverse_(whole.schur_inverse()) {
  const Eigen::MatrixXd differences = (whole.rows() - whole.border())(part_.unknowns, Eigen::all);
  for (Eigen::Index column = 0; column < differences.cols(); ++column) {
    Eigen::VectorXd difference = differences.col(column);
    if (difference.isZero(0)) continue;
    factor_.solve_part(part_, difference);
    solved_rows_.col(column) += difference;
  }
}

Eigen::VectorXd BorderedPart::solve(const Eigen::VectorXd& f) const {
  Eigen::VectorXd x = f;
  factor_.solve_part(part_, x);
  if (solved_columns_.cols() > 0) x += solved_columns_ * (schur_inverse_ * (solved_rows_.transpose() * f));
  return x;
}

}  // namespace thinwall
