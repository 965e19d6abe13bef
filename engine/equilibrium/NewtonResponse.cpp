#include "engine/equilibrium/Newton.hpp"

namespace thinwall {

bool Newton::bears_as_factorised(const EquilibriumProblem& problem) const {
  // A contact that bears nothing any more and yet is a spring in the matrix would hold the wall where it is.
  for (std::size_t k = 0; k < factorised_contacts_.size(); ++k) {
    if (!open_[k] && contact_force(problem, factorised_contacts_[k]) == 0) return false;
  }
  return true;
}

void Newton::evaluate_at_end(const EquilibriumProblem& problem, const EquilibriumState& state) {
  foreseen_stress_.clear();
  evaluate_all(problem, state, true, terms_);
  open_.clear();
  for (const ContactPoint& contact : terms_.contacts) open_.push_back(contact_force(problem, contact) == 0);
  begin_shafts(problem, state);
}

bool Newton::linearize(const EquilibriumProblem& problem, const EquilibriumState& state, bool reuses_factor) {
  const bool is_there = stepped_to_.size() > 0 && stepped_to_ == state.position;
  if (reuses_factor && is_there && bears_as_factorised(problem)) return true;
  evaluate_at_end(problem, state);
  double shift = 0;
  return factorize(problem, state, nullptr, shift, true);
}

LinearAnswer Newton::answer(const EquilibriumProblem& problem, const Eigen::VectorXd& force,
                            std::span<const Eigen::Vector3d> attachment_motion) {
  Residual moved;
  moved.volume.setZero(static_cast<Eigen::Index>(problem.fluids.size()));
  moved.rigid.setZero(problem.hold_rigid_motions ? rigid_columns_.cols() : 0);
  for (std::size_t k = 0; k < problem.attachments.size(); ++k) {
    moved.gaps.push_back(-problem.attachments[k].prescribed.cwiseProduct(attachment_motion[k]));
  }
  Step step;
  solve_linear(problem, force, &moved, step);
  refine_step(problem, force, &moved, step);
  return {.motion = step.position, .forces = step.forces};
}

}  // namespace thinwall
