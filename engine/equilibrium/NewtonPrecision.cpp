#include <algorithm>
#include <optional>
#include <utility>

#include "engine/equilibrium/Newton.hpp"

namespace thinwall {
namespace {

/// Part of its force that a step found with a factor in single precision may miss before it is refined. Membranes with
/// inertia miss up to 1e-3.
constexpr double kMostMissed = 3e-3;

/// Factorisations in double precision after one in single precision that was of no use: as many as make what was lost
/// on it a small part.
constexpr int kDoublesInARow = 16;

}  // namespace

bool Newton::is_usable(std::span<const double> values, const Eigen::VectorXd& expected, bool may_be_saddle,
                       Precision precision) {
  ++factorisations_;
  in_single_precision_ += precision == Precision::kSingle ? 1 : 0;
  SparseFactor& factor = used_factor();
  const bool may_be_indefinite = constraints_ > 0 || may_be_saddle;
  const std::optional<int> negative = factor.factorize(values, may_be_indefinite, precision);
  if (!negative) return false;
  negative_pivots_ = *negative;
  bordered_.expect(expected);
  if (model_.has_open_chambers()) {
    bordered_.set_unsymmetric(factor, *negative, border_, columns_, rows_, corner_);
  } else {
    bordered_.set(factor, *negative, border_, corner_);
  }
  is_convex_ = bordered_.negative_eigenvalues() == constraints_;
  return is_convex_ || may_be_saddle;
}

bool Newton::takes_single_precision(const EquilibriumProblem& problem, const Eigen::VectorXd& expected) {
  // Without inertia a thin wall is so soft across itself that what a step misses, little as it is, moves it far; and
  // the springs of attachments take some digits for themselves.
  if (problem.inertia == 0 || !problem.attachments.empty()) return false;
  // By then the last factor has shown what it is worth.
  if (!(bordered_.missed_part() <= kMostMissed)) doubles_left_ = kDoublesInARow;
  if (doubles_left_ > 0) {
    --doubles_left_;
    return false;
  }
  // What is expected tells whether it will do.
  return expected.size() > 0 && used_factor().is_worth_single_precision();
}

bool Newton::is_usable_in_single(std::span<const double> values, const Eigen::VectorXd& expected, bool may_be_saddle) {
  const bool usable = is_usable(values, expected, may_be_saddle, Precision::kSingle);
  const bool will_do = bordered_.missed_part() <= kMostMissed;
  // Whether a matrix without a shift is convex is not for single precision to deny.
  if (will_do && (usable || !is_exact_)) return usable;
  const bool is_usable_in_double = is_usable(values, expected, may_be_saddle, Precision::kDouble);
  if (is_usable_in_double) doubles_left_ = kDoublesInARow;
  return is_usable_in_double;
}

void Newton::refine_step(const EquilibriumProblem& problem, const Eigen::VectorXd& force, const Residual* missed,
                         Step& step) {
  // Attachments' forces are found by repeating, with factors in double.
  if (used_factor().precision() == Precision::kDouble || !problem.attachments.empty()) return;
  Eigen::VectorXd all = force, multipliers = step.multipliers;
  clear_fixed(all);
  bordered_.refine(used_factor(), all, missed_constraints(problem, missed), step.position, multipliers);
  set_multipliers(problem, std::move(multipliers), step);
}

}  // namespace thinwall
