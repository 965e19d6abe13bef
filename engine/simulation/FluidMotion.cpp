#include "engine/simulation/FluidMotion.hpp"

#include <algorithm>
#include <cmath>

#include "engine/fluid/FluidWeight.hpp"
#include "engine/fluid/LipCap.hpp"
#include "engine/simulation/BackwardDifference.hpp"
#include "engine/simulation/BodyState.hpp"

namespace thinwall {
namespace {

/// Part of the volume of a chamber that is empty whose mass moves all the same: its moment is an unknown.
constexpr double kLeastFluid = 1e-10;

double moving_mass(const BodyModel& model, const BodyState& state, int chamber) {
  const double least = kLeastFluid * model.definition.fluid.density / std::abs(model.chambers[chamber].rest_volume);
  return std::max(least, moment_mass(model, state, chamber));
}

/// Part of the chamber's volume, when it had `volume`, metres^3, that what is in it now less what leaves has.
double motion_scale(const BodyModel& model, const BodyState& state, int chamber, double volume) {
  if (!may_leak(model, chamber) || volume <= 0) return 1;
  double flown = 0;
  for (std::size_t k = 0; k < state.outflow.volumes.size(); ++k) {
    if (model.openings[k].chamber == chamber) flown += state.outflow.volumes[k];
  }
  return std::max(0.0, state.volume[chamber] - flown) / volume;
}

}  // namespace

Eigen::Matrix3Xd first_moments(const BodyModel& model, const Eigen::VectorXd& position) {
  Eigen::Matrix3Xd moments = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(model.chambers.size()));
  for (std::size_t t = 0; t < model.chamber.size(); ++t) {
    const int c = model.chamber[t];
    if (c < 0) continue;
    const auto corners = relative_to(model.chambers[c].level, corners_of(model.surface[t], position));
    moments.col(c) += model.share[t] * first_moment_of(corners).value;
  }
  if (!model.has_fluid()) return moments;
  for (const OpeningModel& opening : model.openings) {
    moments.col(opening.chamber) +=
        lip_moment_of(opening.at(position).colwise() - model.chambers[opening.chamber].level).value;
  }
  return moments;
}

Eigen::Vector3d moment_origin(const BodyModel& model, const BodyState& state, int chamber) {
  const Eigen::Vector3d& level = model.chambers[chamber].level;
  if (!may_leak(model, chamber)) return level;
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

std::vector<FluidMotion> fluid_at_rest(const BodyModel& model, const BodyState& state) {
  std::vector<FluidMotion> motions(model.chambers.size());
  const Eigen::Matrix3Xd moments = first_moments(model, state.equilibrium.position);
  for (std::size_t c = 0; c < motions.size(); ++c) {
    const auto chamber = static_cast<Eigen::Index>(c);
    FluidMotion& motion = motions[c];
    motion.moment = motion.previous_moment = moments.col(chamber);
    motion.volume = motion.previous_volume = state.volume[chamber];
  }
  return motions;
}

std::vector<FluidInertia> fluid_inertia_over(const BodyModel& model, const BodyState& state, double duration) {
  const BackwardDifference difference = backward_difference(duration, state.previous_step);
  const double rate = difference.now / duration;
  std::vector<FluidInertia> inertia;
  for (std::size_t c = 0; c < state.fluid_motion.size(); ++c) {
    const FluidMotion& motion = state.fluid_motion[c];
    const int index = static_cast<int>(c);
    const Eigen::Vector3d origin = moment_origin(model, state, index);
    // Fluid that leaves goes through the lips: seen from there it takes nothing of the moment along.
    const Eigen::Vector3d shift = origin - model.chambers[c].level;
    const Eigen::Vector3d velocity_part =
        (difference.before * (motion.moment - motion.volume * shift) +
         difference.earlier * (motion.previous_moment - motion.previous_volume * shift)) /
        duration;
    // The mean velocity is what stays: what has left has taken its momentum along.
    const Eigen::Vector3d acceleration_part =
        (difference.before * motion_scale(model, state, index, motion.volume) * motion.velocity +
         difference.earlier * motion_scale(model, state, index, motion.previous_volume) * motion.previous_velocity) /
        duration;
    inertia.push_back({.factor = moving_mass(model, state, index) * rate * rate,
                       .target = -(rate * velocity_part + acceleration_part) / (rate * rate),
                       .origin = origin});
  }
  return inertia;
}

std::vector<FluidInertia> fluid_inertia_now(const BodyModel& model, const BodyState& state) {
  std::vector<FluidInertia> inertia;
  for (std::size_t c = 0; c < state.fluid_motion.size(); ++c) {
    const FluidMotion& motion = state.fluid_motion[c];
    const int chamber = static_cast<int>(c);
    const Eigen::Vector3d origin = moment_origin(model, state, chamber);
    const Eigen::Vector3d moment = motion.moment - motion.volume * (origin - model.chambers[c].level);
    inertia.push_back(
        {.factor = moving_mass(model, state, chamber), .target = moment - motion.acceleration, .origin = origin});
  }
  return inertia;
}

void move_fluid(const BodyModel& model, const Eigen::Matrix3Xd& moments, std::span<const FluidInertia> inertia,
                double duration, double previous_step, BodyState& state) {
  const BackwardDifference difference = backward_difference(duration, previous_step);
  for (std::size_t c = 0; c < state.fluid_motion.size(); ++c) {
    FluidMotion& motion = state.fluid_motion[c];
    const FluidMotion before = motion;
    const auto chamber = static_cast<Eigen::Index>(c);
    const Eigen::Vector3d shift = inertia[c].origin - model.chambers[c].level;
    const Eigen::Vector3d moment = moments.col(chamber);
    motion.volume = state.volume[chamber];
    motion.moment = moment + motion.volume * shift;
    motion.velocity = (difference.now * moment + difference.before * (before.moment - before.volume * shift) +
                       difference.earlier * (before.previous_moment - before.previous_volume * shift)) /
                      duration;
    const bool scales = may_leak(model, static_cast<int>(c)) && before.volume > 0 && before.previous_volume > 0;
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

double fluid_kinetic_energy(const BodyModel& model, const BodyState& state) {
  double energy = 0;
  for (std::size_t c = 0; c < state.fluid_motion.size(); ++c) {
    const double mass = moment_mass(model, state, static_cast<int>(c));
    energy += 0.5 * mass * state.fluid_motion[c].velocity.squaredNorm();
  }
  return energy;
}

}  // namespace thinwall
