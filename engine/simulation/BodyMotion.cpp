#include <cmath>

#include "engine/fluid/FluidWeight.hpp"
#include "engine/simulation/BackwardDifference.hpp"
#include "engine/simulation/Body.hpp"

namespace thinwall {
namespace {

/// Part of the volume of a chamber that is empty whose mass moves all the same: its moment is an unknown.
constexpr double kLeastFluid = 1e-10;

double moving_mass(const BodyModel& model, const BodyState& state, int chamber) {
  const double least = kLeastFluid * model.definition.fluid.density / std::abs(model.chambers[chamber].rest_volume);
  return std::max(least, moment_mass(model, state, chamber));
}

}  // namespace

void Body::add_inertia(double duration, EquilibriumProblem& problem) const {
  const BackwardDifference difference = backward_difference(duration, state_.previous_step);
  const double factor = difference.now / duration;
  const Eigen::VectorXd& position = state_.equilibrium.position;
  const Eigen::VectorXd velocity_part =
      (difference.before * position + difference.earlier * state_.previous_position) / duration;
  const Eigen::VectorXd acceleration_part =
      (difference.before * state_.velocity + difference.earlier * state_.previous_velocity) / duration;
  add_fluid_inertia(duration, problem);
  // M (a + mass_rate v) with v = factor x + velocity_part and a = factor v + acceleration_part.
  const double rate = model_->definition.damping.mass_rate;
  problem.inertia = factor * (factor + rate);
  problem.inertia_target = -((factor + rate) * velocity_part + acceleration_part) / problem.inertia;
}

Eigen::Vector3d moment_origin(const BodyModel& model, const BodyState& state, int chamber) {
  const Eigen::Vector3d& level = model.chambers[chamber].level;
  if (!model.is_open(chamber) || !model.definition.fluid.leaks) return level;
  double whole = 0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < model.openings.size(); ++k) {
    if (model.openings[k].chamber != chamber) continue;
    const double area = state.open_area[static_cast<Eigen::Index>(k)];
    origin += area * model.openings[k].at(state.equilibrium.position).rowwise().mean();
    whole += area;
  }
  return whole > 0 ? Eigen::Vector3d(origin / whole) : level;
}

double moment_mass(const BodyModel& model, const BodyState& state, int chamber) {
  const double volume = state.volume[chamber], fluid = state.fluid_volume[chamber];
  return model.definition.fluid.density * (model.is_open(chamber) ? fluid / (volume * volume) : 1 / fluid);
}

PressureField pressure_of_inertia(const BodyModel& model, const BodyState& state, int chamber) {
  if (state.fluid_motion.empty()) return {};
  const Eigen::Vector3d push = moment_mass(model, state, chamber) * state.fluid_motion[chamber].acceleration;
  return {.at_origin = push.dot(moment_origin(model, state, chamber)), .slope = -push};
}

double Body::fluid_kinetic_energy() const {
  double energy = 0;
  for (std::size_t c = 0; c < state_.fluid_motion.size(); ++c) {
    const double mass = moment_mass(*model_, state_, static_cast<int>(c));
    energy += 0.5 * mass * state_.fluid_motion[c].velocity.squaredNorm();
  }
  return energy;
}

void Body::start_fluid_motion() {
  state_.fluid_motion.assign(model_->chambers.size(), {});
  const Eigen::Matrix3Xd moments = first_moments(*model_, state_.equilibrium.position);
  for (std::size_t c = 0; c < state_.fluid_motion.size(); ++c) {
    const auto chamber = static_cast<Eigen::Index>(c);
    FluidMotion& motion = state_.fluid_motion[c];
    motion.moment = motion.previous_moment = moments.col(chamber);
    motion.volume = motion.previous_volume = state_.volume[chamber];
  }
}

double Body::motion_scale(int chamber, double volume) const {
  if (!may_leak(chamber) || volume <= 0) return 1;
  double flown = 0;
  for (std::size_t k = 0; k < state_.outflow.volumes.size(); ++k) {
    if (model_->openings[k].chamber == chamber) flown += state_.outflow.volumes[k];
  }
  return std::max(0.0, state_.volume[chamber] - flown) / volume;
}

void Body::add_fluid_inertia(double duration, EquilibriumProblem& problem) const {
  const BackwardDifference difference = backward_difference(duration, state_.previous_step);
  const double rate = difference.now / duration;
  problem.fluid_inertia.clear();
  for (std::size_t c = 0; c < state_.fluid_motion.size(); ++c) {
    const FluidMotion& motion = state_.fluid_motion[c];
    const int index = static_cast<int>(c);
    const Eigen::Vector3d origin = moment_origin(*model_, state_, index);
    // Fluid that leaves goes through the lips: seen from there it takes nothing of the moment along.
    const Eigen::Vector3d shift = origin - model_->chambers[c].level;
    const Eigen::Vector3d velocity_part =
        (difference.before * (motion.moment - motion.volume * shift) +
         difference.earlier * (motion.previous_moment - motion.previous_volume * shift)) /
        duration;
    // The mean velocity is what stays: what has left has taken its momentum along.
    const Eigen::Vector3d acceleration_part =
        (difference.before * motion_scale(index, motion.volume) * motion.velocity +
         difference.earlier * motion_scale(index, motion.previous_volume) * motion.previous_velocity) /
        duration;
    problem.fluid_inertia.push_back({.factor = moving_mass(*model_, state_, index) * rate * rate,
                                     .target = -(rate * velocity_part + acceleration_part) / (rate * rate),
                                     .origin = origin});
  }
}

void Body::add_fluid_inertia_as_it_is(EquilibriumProblem& problem) const {
  for (std::size_t c = 0; c < state_.fluid_motion.size(); ++c) {
    const FluidMotion& motion = state_.fluid_motion[c];
    const int chamber = static_cast<int>(c);
    const Eigen::Vector3d origin = moment_origin(*model_, state_, chamber);
    const Eigen::Vector3d moment = motion.moment - motion.volume * (origin - model_->chambers[c].level);
    problem.fluid_inertia.push_back(
        {.factor = moving_mass(*model_, state_, chamber), .target = moment - motion.acceleration, .origin = origin});
  }
}

void Body::update_fluid_motion(double duration, double previous_step, const EquilibriumProblem& problem) {
  const BackwardDifference difference = backward_difference(duration, previous_step);
  for (std::size_t c = 0; c < state_.fluid_motion.size(); ++c) {
    FluidMotion& motion = state_.fluid_motion[c];
    const FluidMotion before = motion;
    const auto chamber = static_cast<Eigen::Index>(c);
    const Eigen::Vector3d shift = problem.fluid_inertia[c].origin - model_->chambers[c].level;
    const Eigen::Vector3d moment = newton_->terms().moment.col(chamber);
    motion.volume = state_.volume[chamber];
    motion.moment = moment + motion.volume * shift;
    motion.velocity = (difference.now * moment + difference.before * (before.moment - before.volume * shift) +
                       difference.earlier * (before.previous_moment - before.previous_volume * shift)) /
                      duration;
    const bool scales = may_leak(static_cast<int>(c)) && before.volume > 0 && before.previous_volume > 0;
    motion.acceleration =
        (difference.now * motion.velocity +
         difference.before * (scales ? motion.volume / before.volume : 1) * before.velocity +
         difference.earlier * (scales ? motion.volume / before.previous_volume : 1) * before.previous_velocity) /
        duration;
    motion.previous_moment = before.moment;
    motion.previous_velocity = before.velocity;
    motion.previous_volume = before.volume;
  }
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
    update_fluid_motion(duration, before.previous_step, problem);
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

double Body::step_error(const BodyState& before, double duration) const {
  if (options_.analysis != Analysis::kDynamic) return 0;
  const Eigen::VectorXd uniform = before.equilibrium.position + duration * before.velocity;
  if (before.previous_step == 0) {
    // A backward Euler step misses half of the square of the step times the acceleration.
    return 0.5 * (state_.equilibrium.position - uniform).head(3 * model_->vertices()).lpNorm<Eigen::Infinity>();
  }
  // With j the third derivative, h the step and an equal one before, the prediction misses h^3 j / 6 on one side and
  // the backward difference 2 h^3 j / 9 on the other.
  const Eigen::VectorXd predicted = uniform + 0.5 * duration * duration * before.acceleration;
  return 4.0 / 7 * (state_.equilibrium.position - predicted).head(3 * model_->vertices()).lpNorm<Eigen::Infinity>();
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
  add_friction_to_contacts(problem);
  state_.attachments = problem.attachments;
  for (const Attachment& attachment : state_.attachments) {
    state_.contacts[attachment.tool].force += attachment.force;
    state_.contacts[attachment.tool].touching = true;
  }
}

}  // namespace thinwall
