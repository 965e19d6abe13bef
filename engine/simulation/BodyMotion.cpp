#include <cmath>
#include <utility>

#include "engine/simulation/Body.hpp"

namespace thinwall {
namespace {

/// Coefficients of the second-order backward difference of a step h after one of h / ratio:
/// y' = (now y1 + before y0 + earlier y-1) / h; with ratio zero it is the backward Euler difference.
struct BackwardDifference {
  double now, before, earlier;
};
BackwardDifference backward_difference(double ratio) {
  return {.now = (1 + 2 * ratio) / (1 + ratio), .before = -(1 + ratio), .earlier = ratio * ratio / (1 + ratio)};
}

}  // namespace

double fluid_energy(const BodyModel& model, const BodyState& state) {
  if (model.definition.fluid.kind != FluidKind::kCompressible) return 0;
  const double excess = state.volume - state.fluid_volume;
  return -state.reference_pressure * excess +
         0.5 * model.definition.fluid.bulk_modulus * excess * excess / state.fluid_volume;
}

void Body::add_inertia(double duration, EquilibriumProblem& problem) const {
  const double ratio = state_.previous_step > 0 ? duration / state_.previous_step : 0;
  const BackwardDifference difference = backward_difference(ratio);
  const double factor = difference.now / duration;
  problem.inertia = factor * factor;
  const Eigen::VectorXd& position = state_.equilibrium.position;
  const Eigen::VectorXd velocity_part =
      (difference.before * position + difference.earlier * state_.previous_position) / duration;
  const Eigen::VectorXd acceleration_part =
      (difference.before * state_.velocity + difference.earlier * state_.previous_velocity) / duration;
  problem.inertia_target = -(factor * velocity_part + acceleration_part) / problem.inertia;
}

void Body::accept(std::span<const ToolPose> begin, double duration, const EquilibriumProblem& problem,
                  const EquilibriumState& reached) {
  const BodyState before = state_;
  state_.equilibrium = reached;
  state_.volume = newton_.terms().volume;
  if (problem.inertia != 0) update_velocity(before, duration, problem);
  state_.previous_position = before.equilibrium.position;
  state_.previous_velocity = before.velocity;
  state_.previous_step = duration;
  update_forces(problem);
  update_books(before, begin, problem);
}

void Body::update_velocity(const BodyState& before, double duration, const EquilibriumProblem& problem) {
  const BackwardDifference difference =
      backward_difference(before.previous_step > 0 ? duration / before.previous_step : 0);
  const Eigen::VectorXd& position = state_.equilibrium.position;
  state_.velocity = (difference.now * position + difference.before * before.equilibrium.position +
                     difference.earlier * before.previous_position) /
                    duration;
  state_.acceleration = problem.inertia * (position - problem.inertia_target);
}

void Body::update_forces(const EquilibriumProblem& problem) {
  const EquilibriumTerms& terms = newton_.terms();
  state_.static_force = terms.gradient - state_.equilibrium.pressure * terms.volume_gradient;
  for (const ContactPoint& contact : terms.contacts) {
    const double force = problem.spheres[contact.sphere].forces[contact.triangle];
    for (int k = 0; k < 3; ++k) {
      state_.static_force.segment<3>(3 * model_->surface[contact.triangle][k]) -=
          force * contact.gap.gradient.segment<3>(3 * k);
    }
  }
  state_.contacts.assign(tools_.size(), ToolContact{});
  for (std::size_t k = 0; k < problem.spheres.size(); ++k) {
    const int tool = problem.spheres[k].tool;
    state_.contacts[tool] = contact_on(problem, terms, static_cast<int>(k));
    state_.sphere_forces[tool] = problem.spheres[k].forces;
  }
  state_.attachments = problem.attachments;
  for (const Attachment& attachment : state_.attachments) {
    state_.contacts[attachment.tool].force += attachment.force;
    state_.contacts[attachment.tool].touching = true;
  }
}

void Body::update_books(const BodyState& before, std::span<const ToolPose> begin, const EquilibriumProblem& problem) {
  EnergyBooks& books = state_.books;
  books.elastic = newton_.terms().elastic;
  books.kinetic = 0.5 * model_->mass.dot(state_.velocity.cwiseAbs2());
  books.contact = contact_energy(*model_, problem, newton_.terms());
  books.fluid = fluid_energy(*model_, state_);

  // Work by the trapezoidal rule; what it differs from the change of the energies is what the integrator spends.
  const Eigen::VectorXd motion = state_.equilibrium.position - before.equilibrium.position;
  double attached_work = 0, sphere_work = 0, script_work = 0;
  for (const std::vector<Attachment>* attachments : {&before.attachments, &std::as_const(state_).attachments}) {
    for (const Attachment& attachment : *attachments) {
      attached_work -= 0.5 * attachment.force.dot(material_point(attachment, motion));
    }
  }
  for (const SphereContact& contact : problem.spheres) {
    const Eigen::Vector3d path = contact.sphere.center - sphere_at(tools_[contact.tool], begin[contact.tool]).center;
    sphere_work -= 0.5 * (before.contacts[contact.tool].force + state_.contacts[contact.tool].force).dot(path);
  }
  if (problem.fluid == FluidMode::kIncompressible) {
    script_work = 0.5 * (before.equilibrium.pressure + state_.equilibrium.pressure) * (state_.volume - before.volume);
  }
  const double kinetic_work = 0.5 * model_->mass.cwiseProduct(before.acceleration + state_.acceleration).dot(motion);
  const double static_work = 0.5 * (before.static_force + state_.static_force).dot(motion) + sphere_work + script_work;
  books.numerical += kinetic_work + static_work - (books.stored() - before.books.stored());
  books.tool_work += attached_work + sphere_work;
  books.script_work += script_work;
}

}  // namespace thinwall
