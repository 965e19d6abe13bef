#include "engine/equilibrium/Newton.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

/// After this many iterations steps are halved at once: whole ones may go to and fro between two sets of contacts, one
/// of which lowers the residual and the other the energy. After so many calm ones in a row there is one set, and whole
/// ones lead to the end; so they do where the energy fell as foreseen, as along a bent valley, in which the residual
/// hardly falls from step to step, and half steps creep.
constexpr int kWholeSteps = 15;
constexpr int kCalmSteps = 2;

/// So many steps without line search, in a row without gain, end these in a shell whose flaps are taken: where such a
/// wall buckles they go astray for good, and most of them ask for several matrices, while the search along steps then
/// takes some five to ten. A whole wall that snaps through may find another equilibrium so.
constexpr int kForeseeingWithoutGain = 8;

/// Part to which the residual falls in a calm iteration.
constexpr double kCalmFall = 0.7;

/// Where a step brought the residual down to this part, to this multiple of the tolerance, and to this part of the
/// largest force, the next one is found with the same factor: it is off by what the step changed.
constexpr double kSteepFall = 0.3;
constexpr double kNearTheEnd = 30;
constexpr double kSmallResidual = 3e-3;

/// With the factor of the last step a residual falls by some twice the ratio by which it just fell, as that was by the
/// square of what it was. Where this part of the tolerance is reached so in two steps a body that leaks asks for no new
/// one: it ends within the tolerance, where others, whose books are to close to round-off, end far below it.
constexpr double kSurelyWithin = 0.5;

}  // namespace

bool Newton::may_keep_factor(const EquilibriumProblem& problem, const Residual& residual, double tolerance,
                             double scale, const Progress& progress) {
  if (factorisations_ == 0 || !is_exact_ || folded_ || terms_.folds.energy > 0 || !problem.shafts.empty()) return false;
  const double force = residual.largest_force, fall = force / progress.last_force;
  const bool is_near =
      may_be_one_by_one_ && force <= std::min(kNearTheEnd * tolerance, kSmallResidual * scale) && fall <= kSteepFall;
  const bool ends = progress.kept == 0 ? force * (2 * fall) * (2 * fall) <= kSurelyWithin * tolerance
                                       : progress.kept == 1 && force * fall <= kSurelyWithin * tolerance;
  // Which contacts bear is found with each new factor: those that let go ask for one.
  const bool may_end = ends && model_.has_open_chambers() && model_.definition.fluid.leaks && residual.ghost == 0;
  return ((is_near && progress.kept == 0) || may_end) && find_factorised_contacts();
}

bool Newton::Progress::tries_whole_step(int iterations) const {
  return iterations < kWholeSteps || calm >= kCalmSteps || descent == Descent::kAsForeseen;
}

bool Newton::Progress::goes_astray() const {
  return without_gain >= kForeseeingWithoutGain;
}

bool Newton::Progress::foresees_end(const Residual& residual, double tolerance) const {
  return residual.largest_force * residual.largest_force <= tolerance * last_force;
}

void Newton::Progress::note(const Residual& residual) {
  calm = residual.measure < kCalmFall * last_measure ? calm + 1 : 0;
  last_measure = residual.measure;
  // The matrix as it is serves as long as the residual falls with it.
  if (takes_saddle) inexact = calm > 0 ? inexact + 1 : 0;
  stalled = residual.largest_force < kCalmFall * least_force ? 0 : stalled + 1;
  // Where a wall is all but in equilibrium its first step may leave more than there was.
  if (std::isfinite(least_force)) {
    without_gain = residual.largest_force < kCalmFall * least_stepped ? 0 : without_gain + 1;
    least_stepped = std::min(least_stepped, residual.largest_force);
  }
  least_force = std::min(least_force, residual.largest_force);
  last_force = force;
  force = residual.largest_force;
}

}  // namespace thinwall
