#include "engine/equilibrium/FoldMatrix.hpp"

namespace thinwall {

bool FoldMatrix::has_room(const SelfContactTerms& folds) const {
  if (!factor_) return false;
  for (const FoldContact& fold : folds.folds) {
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < a; ++b) {
        if (!is_coupled(extended_.pattern, fold.vertices[a], fold.vertices[b])) return false;
      }
    }
  }
  return true;
}

bool FoldMatrix::prepare(const SelfContactTerms& folds, const SelfContact& contact) {
  if (folds.folds.empty()) return false;
  if (!has_room(folds)) {
    extended_ = extend_block_pattern(model_.pattern, contact.near_couplings());
    factor_.emplace(extended_.pattern);
  }
  return true;
}

std::span<const double> FoldMatrix::assemble(std::span<const double> values, const SelfContactTerms& folds,
                                             bool exact) {
  values_.assign(extended_.pattern.nonzeros(), 0);
  for (std::size_t k = 0; k < values.size(); ++k) values_[extended_.entries[k]] = values[k];
  for (const FoldContact& fold : folds.folds) {
    Eigen::Matrix<double, 12, 12> hessian = exact ? fold.pair.hessian() : fold.pair.convex_hessian();
    for (int k = 0; k < 12; ++k) {
      if (!model_.fixed[3 * fold.vertices[k / 3] + k % 3]) continue;
      hessian.row(k).setZero();
      hessian.col(k).setZero();
    }
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b <= a; ++b) {
        add_block(extended_.pattern, fold.vertices[a], fold.vertices[b], hessian.block<3, 3>(3 * a, 3 * b), values_);
      }
    }
  }
  return values_;
}

void add_floors(const BodyModel& model, const SelfContactTerms& folds, std::span<double> values) {
  for (const FloorContact& floor : folds.floors) {
    add_block(model.pattern, floor.vertex, floor.vertex,
              floor.terms.curvature * floor.normal * floor.normal.transpose(), values);
  }
}

}  // namespace thinwall
