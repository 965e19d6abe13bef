#include <algorithm>

#include "engine/simulation/BackwardDifference.hpp"
#include "engine/simulation/Body.hpp"
#include "engine/simulation/ToolFriction.hpp"

namespace thinwall {
namespace {

/// Part of its rest area that a triangle has at least as the area that is pressed: one that is crumpled to nothing
/// would have a pressure without bound.
constexpr double kLeastPressedPart = 0.01;

}  // namespace

void Body::add_inertia(double duration, EquilibriumProblem& problem) const {
  const BackwardDifference difference = backward_difference(duration, state_.previous_step);
  const double factor = difference.now / duration;
  const Eigen::VectorXd& position = state_.equilibrium.position;
  const Eigen::VectorXd velocity_part =
      (difference.before * position + difference.earlier * state_.previous_position) / duration;
  const Eigen::VectorXd acceleration_part =
      (difference.before * state_.velocity + difference.earlier * state_.previous_velocity) / duration;
  problem.fluid_inertia = fluid_inertia_over(*model_, state_, duration);
  // M (a + mass_rate v) with v = factor x + velocity_part and a = factor v + acceleration_part.
  const double rate = model_->definition.damping.mass_rate;
  problem.inertia = factor * (factor + rate);
  problem.inertia_target = -((factor + rate) * velocity_part + acceleration_part) / problem.inertia;
}

void Body::accept(std::span<const ToolPose> begin, double duration, const EquilibriumProblem& problem,
                  const BodyInput& input, const EquilibriumState& reached) {
  const BodyState before = state_;
  state_.equilibrium = reached;
  find_drag(before.equilibrium.position);
  report_.slowed = report_.slowed || state_.drag_force.size() > 0;
  report_.loose = report_.loose || is_loose_;
  report_.unstable = report_.unstable || is_unstable_;
  report_.held = stays_held_ && !has_inertia();
  state_.volume = newton_->terms().volume;
  state_.load_factors = input.load_factors;
  update_fluids(duration, input, problem);
  if (problem.inertia != 0) {
    update_velocity(before, duration);
    move_fluid(*model_, newton_->terms().moment, problem.fluid_inertia, duration, before.previous_step, state_);
  }
  state_.previous_position = before.equilibrium.position;
  state_.previous_velocity = before.velocity;
  state_.previous_step = duration;
  update_forces(problem);
  update_books(before, begin, duration, problem, input);
}

void Body::update_velocity(const BodyState& before, double duration) {
  const BackwardDifference difference = backward_difference(duration, before.previous_step);
  const Eigen::VectorXd& position = state_.equilibrium.position;
  state_.velocity = (difference.now * position + difference.before * before.equilibrium.position +
                     difference.earlier * before.previous_position) /
                    duration;
  state_.acceleration = (difference.now * state_.velocity + difference.before * before.velocity +
                         difference.earlier * before.previous_velocity) /
                        duration;
}

void Body::update_forces(const EquilibriumProblem& problem) {
  const EquilibriumTerms& terms = newton_->terms();
  state_.static_force = terms.gradient - terms.load_of_pressure() * state_.equilibrium.pressure;
  state_.load_force = terms.load_force;
  for (const ContactPoint& contact : terms.contacts) {
    const double force = problem.solids[contact.solid].forces[contact.site];
    for (int k = 0; k < 3; ++k) {
      state_.static_force.segment<3>(3 * model_->surface[contact.triangle][k]) -=
          force * contact.gap.gradient.segment<3>(3 * k);
    }
  }
  state_.contacts.assign(tools_.size(), ToolContact{});
  for (std::size_t k = 0; k < problem.solids.size(); ++k) {
    const ToolContact own = contact_on(*model_, problem, terms, state_.equilibrium.position, static_cast<int>(k));
    ToolContact& whole = state_.contacts[problem.solids[k].tool];
    whole.force += own.force;
    whole.area += own.area;
    whole.touching = whole.touching || own.touching;
    state_.solid_contacts[k] = own;
    state_.solid_forces[k] = problem.solids[k].forces;
  }
  add_friction_forces(*model_, problem, state_);
  state_.attachments = problem.attachments;
  for (const Attachment& attachment : state_.attachments) {
    state_.contacts[attachment.tool].force += attachment.force;
    state_.contacts[attachment.tool].touching = true;
  }
}

double Body::squeeze(int tool, const ToolPose& pose) const {
  std::size_t k = 0;
  for (int before = 0; before < tool; ++before) k += contact_solids(tools_[before], {}).size();
  const Eigen::Vector3d across = pose.axis.cross(pose.direction);
  // The wall between the jaws pushes each outwards.
  double right = 0, left = 0;
  for (const ToolSolid& solid : contact_solids(tools_[tool], pose)) {
    const double outwards = state_.solid_contacts[k++].force.dot(across);
    (across.dot(solid.center - pose.tip) > 0 ? right : left) += outwards;
  }
  return std::max(0.0, std::min(right, -left));
}

Eigen::VectorXd Body::contact_pressure() const {
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(model_->vertices());
  for (const Attachment& attachment : state_.attachments) {
    for (int k = 0; k < 3; ++k) pressure[attachment.vertices[k]] += attachment.weights[k] * attachment.force.norm();
  }
  for (const std::vector<double>& forces : state_.solid_forces) {
    for (std::size_t s = 0; s < forces.size(); ++s) {
      if (forces[s] == 0) continue;
      const ContactSite& site = model_->sites[s];
      const Eigen::Vector3i& triangle = model_->surface[site.triangle];
      const int count = vertex_count_of(site.part);
      for (int k = 0; k < count; ++k) pressure[triangle[(site.corner + k) % 3]] += forces[s] / count;
    }
  }
  Eigen::VectorXd area = Eigen::VectorXd::Zero(model_->vertices());
  for (int t = 0; t < model_->triangles(); ++t) {
    const auto corners = corners_of(model_->surface[t], state_.equilibrium.position);
    const double now = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
    const double least = kLeastPressedPart * model_->rest[t].area;
    for (const int vertex : model_->surface[t]) area[vertex] += std::max(now, least) / 3;
  }
  return pressure.cwiseQuotient(area.cwiseMax(1e-300));
}

}  // namespace thinwall
