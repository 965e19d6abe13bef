#include <algorithm>
#include <utility>

#include "engine/equilibrium/Newton.hpp"
#include "engine/equilibrium/PatchRelaxation.hpp"

// Where a blade has left flaps of a slack wall behind, one step of the whole wall after the other goes into the turns
// of a few of their triangles. So these are solved with the rest of the wall held, and the whole goes on from there.

namespace thinwall {
namespace {

/// Patches are relaxed where residuals may be that large. Where they must be smaller most steps go into the last
/// digits, which a patch has no part in.
constexpr double kLooseTolerance = 1e-4;

/// Before that the whole wall has yet to follow tools and fluid, and after so many steps patches have not helped.
constexpr int kFirstRelaxed = 1;
constexpr int kLastRelaxed = 11;

/// Part to which the gradient of a patch is brought down, and part of what is left of it of the residual wanted.
constexpr double kPatchFall = 1e-3;
constexpr double kPatchShare = 0.1;

/// Part to which the residual of the whole wall must have fallen then: otherwise all stays as it was.
constexpr double kEnoughFall = 0.7;

/// Patches that are relaxed one after the other.
constexpr int kMostPatches = 3;

/// What tools hold, and lies on a floor.
std::vector<char> held_vertices(const BodyModel& model, const EquilibriumProblem& problem,
                                const EquilibriumTerms& terms) {
  std::vector<char> held(model.vertices(), 0);
  const auto hold = [&](const Eigen::Vector3i& vertices) {
    for (const int vertex : vertices) held[vertex] = 1;
  };
  for (const ContactPoint& contact : terms.contacts) {
    if (problem.solids[contact.solid].forces[contact.site] != 0) hold(model.surface[contact.triangle]);
  }
  for (const Attachment& attachment : problem.attachments) hold(attachment.vertices);
  for (const FloorContact& floor : terms.folds.floors) held[floor.vertex] = 1;
  return held;
}

}  // namespace

bool Newton::may_relax_patches(const EquilibriumProblem& problem, const NewtonOptions& options, int iterations) const {
  const bool is_membrane = model_.bending.empty();
  return is_membrane && options.takes_flaps && options.tolerance >= kLooseTolerance && !keeps_factor_ &&
         problem.shafts.empty() && iterations >= kFirstRelaxed && iterations <= kLastRelaxed;
}

void Newton::relax_patches(const EquilibriumProblem& problem, EquilibriumState& state, const NewtonOptions& options) {
  Residual residual;
  compute_residual(problem, state, terms_, residual);
  const double wanted = options.tolerance * force_scale(problem, terms_, options.tolerance);
  for (int patch = 0; patch < kMostPatches && residual.largest_force > wanted; ++patch) {
    if (!relax_patch(problem, state, kPatchShare * wanted, residual)) return;
  }
}

bool Newton::relax_patch(const EquilibriumProblem& problem, EquilibriumState& state, double goal, Residual& residual) {
  const auto patch = patch_around(model_, residual.force, held_vertices(model_, problem, terms_));
  if (!patch) return false;
  const Eigen::VectorXd before = state.position;
  PatchEnergy energy(model_, problem, *patch, self_contact_.near_pairs_of(patch->has), self_contact_.pressure(), before,
                     residual.force);
  const Eigen::VectorXd way = relaxed(energy, before, std::max(kPatchFall * energy.gradient().norm(), goal)) - before;
  state.position += self_contact_.safe_fraction(before, way) * way;
  evaluate_all(problem, state, true, trial_terms_);
  Residual reached;
  compute_residual(problem, state, trial_terms_, reached);
  // Asked this way round, what is not a number is no fall.
  if (reached.measure <= kEnoughFall * residual.measure) {
    std::swap(terms_, trial_terms_);
    residual = reached;
    return true;
  }
  state.position = before;
  // What lies near itself is listed for where the wall is.
  self_contact_.look(before);
  return false;
}

}  // namespace thinwall
