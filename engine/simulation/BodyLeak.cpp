// What runs out of a body through openings of its wall, and the air that comes in.
//
// Fluid leaves by FlowMemory's rule. A chamber ends each step in one of two states: filled, with a pressure at its
// openings that is not negative; or with air at the opening where the pressure is lowest, which is zero there while the
// volume is free and not below that of the fluid. Both are tried until one holds.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/fluid/FluidWeight.hpp"
#include "engine/simulation/BackwardDifference.hpp"
#include "engine/simulation/Body.hpp"
#include "engine/simulation/OpenChambers.hpp"

namespace thinwall {
namespace {

/// Times within a step that chambers may turn from filled to aired and back.
constexpr int kMostVentTurns = 6;

/// Pressure below zero, over the wall's scale of pressure, that counts as none: what the solver leaves is 1e-11 of it.
constexpr double kNoPressure = 1e-9;

/// Volume over the rest volume by which fluid and wall may miss each other: the solver leaves 1e-11 of it.
constexpr double kNoVolume = 1e-10;

/// Pascal: what a balloon of the wall and size bears at unit strain.
double pressure_scale(const BodyModel& model) {
  return model.wall_stiffness / std::sqrt(model.rest_area);
}

double density_of(const BodyModel& model, const BodyState& state, int chamber) {
  const double density = model.definition.fluid.density;
  return state.air[chamber] > 0 ? density * state.fluid_volume[chamber] / state.volume[chamber] : density;
}

/// An opening at a state.
struct LipState {
  Eigen::Vector3d center;  // metres
  double area;             // metres^2
  double pressure;         // pascal, at the centre
  Eigen::Matrix3Xd load;   // (3 x lips), newton, that the cap does not bear
};

LipState lip_state_of(const BodyModel& model, const BodyState& state, const Eigen::Vector3d& gravity,
                      const OpeningModel& opening) {
  const int c = opening.chamber;
  const Eigen::Matrix3Xd lips = opening.at(state.equilibrium.position);
  const LipCap cap = lip_cap_of(lips);
  PressureField field;
  field.slope = density_of(model, state, c) * gravity;
  field.at_origin = state.equilibrium.pressure[c] - field.slope.dot(model.chambers[c].level);
  return {.center = cap.center,
          .area = cap.area.norm(),
          .pressure = field.at(cap.center),
          .load = lip_load_of(lips, field)};
}

/// What a volume of fluid that leaves takes along beside the work of its pressure, joule / metre^3: its motion, and
/// what a compressible one has stored less than that work.
double carried_energy(const BodyModel& model, const BodyState& state, int chamber) {
  const FluidDefinition& fluid = model.definition.fluid;
  double energy = 0;
  if (!state.fluid_motion.empty() && state.volume[chamber] > 0) {
    energy += 0.5 * fluid.density * (state.fluid_motion[chamber].velocity / state.volume[chamber]).squaredNorm();
  }
  if (fluid.kind == FluidKind::kCompressible) {
    const double excess = state.equilibrium.pressure[chamber] - state.reference_pressure[chamber];
    energy -= 0.5 * excess * excess / fluid.bulk_modulus;
  }
  return energy;
}

}  // namespace

Eigen::Matrix3Xd first_moments(const BodyModel& model, const Eigen::VectorXd& position) {
  Eigen::Matrix3Xd moments = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(model.chambers.size()));
  for (std::size_t t = 0; t < model.chamber.size(); ++t) {
    const int c = model.chamber[t];
    const auto corners = relative_to(model.chambers[c].level, corners_of(model.surface[t], position));
    for (int axis = 0; axis < 3; ++axis) {
      moments(axis, c) += fluid_moment_of(corners, Eigen::Vector3d::Unit(axis)).value;
    }
  }
  if (!model.has_fluid()) return moments;
  for (const OpeningModel& opening : model.openings) {
    moments.col(opening.chamber) +=
        lip_moment_of(opening.at(position).colwise() - model.chambers[opening.chamber].level).value;
  }
  return moments;
}

double open_gravity(const BodyModel& model, const EquilibriumProblem& problem, const BodyState& state) {
  if (!model.has_open_chambers() || problem.gravity.isZero()) return 0;
  double energy = 0;
  const Eigen::Matrix3Xd moments = first_moments(model, state.equilibrium.position);
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    if (!model.is_open(c)) continue;
    const double density = density_of(model, state, c);
    energy -= (density - problem.fluids[c].density) * problem.gravity.dot(moments.col(c));
    energy -=
        (density - model.definition.fluid.density) * problem.gravity.dot(model.chambers[c].level) * state.volume[c];
  }
  return energy;
}

bool Body::may_leak(int chamber) const {
  return model_->is_open(chamber) && model_->definition.fluid.leaks;
}

void Body::start_leaks() {
  const auto chambers = static_cast<Eigen::Index>(model_->chambers.size());
  state_.leaked = state_.air = Eigen::VectorXd::Zero(chambers);
  state_.outflow = {};
  measure_openings();
}

void Body::measure_openings() {
  state_.open_area.resize(static_cast<Eigen::Index>(model_->openings.size()));
  for (std::size_t k = 0; k < model_->openings.size(); ++k) {
    state_.open_area[static_cast<Eigen::Index>(k)] =
        lip_cap_of(model_->openings[k].at(state_.equilibrium.position)).area.norm();
  }
}

void Body::add_leaks(double duration, EquilibriumProblem& problem) const {
  if (!model_->has_open_chambers()) return;
  std::vector<double> lowest(problem.fluids.size(), 0);
  for (std::size_t k = 0; k < model_->openings.size(); ++k) {
    const OpeningModel& opening = model_->openings[k];
    const int c = opening.chamber;
    FluidProblem& fluid = problem.fluids[c];
    fluid.density = density_of(*model_, state_, c);
    if (!may_leak(c) || !fluid.is_multiplier()) continue;
    fluid.fluid_volume -= state_.outflow.share(k, duration);
    fluid.outflow_time = state_.outflow.time(duration);
    fluid.vent_compliance = std::abs(model_->chambers[c].rest_volume) / pressure_scale(*model_);
    if (state_.air[c] <= 0) continue;
    const double pressure = lip_state_of(*model_, state_, options_.gravity, opening).pressure;
    if (fluid.vent < 0 || pressure < lowest[c]) {
      fluid.vent = static_cast<int>(k);
      lowest[c] = pressure;
    }
  }
}

std::vector<double> Body::outflow_of(double duration, const EquilibriumProblem& problem,
                                     const EquilibriumState& reached) const {
  std::vector<double> flown(model_->openings.size(), 0);
  if (!model_->has_open_chambers()) return flown;
  const EquilibriumTerms& terms = newton_.terms();
  std::vector<double> left(problem.fluids.size(), 0);  // metres^3, of fluid at the end of the step, before the vent
  for (std::size_t c = 0; c < left.size(); ++c) left[c] = problem.fluids[c].fluid_volume;
  for (std::size_t k = 0; k < flown.size(); ++k) {
    const int c = model_->openings[k].chamber;
    if (!may_leak(c)) continue;
    flown[k] = state_.outflow.share(k, duration);
    if (problem.fluids[c].vent == static_cast<int>(k)) continue;
    const double pressure = lip_pressure(*model_, problem, terms, static_cast<int>(k), reached.pressure);
    const double now =
        state_.outflow.time(duration) * outflow(*model_, terms.lips[k].area.norm(), std::max(0.0, pressure)).rate;
    flown[k] += now;
    left[c] -= now;
  }
  // Where the pressure is zero as much has left as the wall has pressed out, at most what the step before leads to.
  for (std::size_t c = 0; c < problem.fluids.size(); ++c) {
    const int vent = problem.fluids[c].vent;
    if (vent < 0) continue;
    const double share = state_.outflow.share(static_cast<std::size_t>(vent), duration);
    flown[vent] = std::clamp(share + left[c] - fluid_held(problem, static_cast<int>(c), reached), 0.0, share);
  }
  return flown;
}

double Body::fluid_held(const EquilibriumProblem& problem, int chamber, const EquilibriumState& reached) const {
  return newton_.terms().volume[chamber] / problem.fluids[chamber].held(reached.pressure[chamber]);
}

bool Body::revise_vents(EquilibriumProblem& problem, const EquilibriumState& reached, double duration) const {
  const EquilibriumTerms& terms = newton_.terms();
  bool revised = false;
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    FluidProblem& fluid = problem.fluids[c];
    if (!may_leak(c) || !fluid.is_multiplier()) continue;
    int lowest = -1;
    double pressure = -kNoPressure * pressure_scale(*model_);
    for (int k = 0; k < static_cast<int>(model_->openings.size()); ++k) {
      if (model_->openings[k].chamber != c) continue;
      const double at_lips = lip_pressure(*model_, problem, terms, k, reached.pressure);
      if (at_lips < pressure) lowest = k, pressure = at_lips;
    }
    if (lowest >= 0) {
      fluid.vent = lowest;
      revised = true;
    } else if (fluid.vent >= 0) {
      const std::vector<double> flown = outflow_of(duration, problem, reached);
      double left = fluid.fluid_volume;
      for (std::size_t k = 0; k < flown.size(); ++k) {
        if (model_->openings[k].chamber == c) left -= flown[k] - state_.outflow.share(k, duration);
      }
      if (left - fluid_held(problem, c, reached) <= kNoVolume * std::abs(model_->chambers[c].rest_volume)) continue;
      fluid.vent = -1;
      revised = true;
    }
  }
  return revised;
}

bool Body::solve_with_leaks(EquilibriumProblem& problem, EquilibriumState& trial, std::span<const ToolPose> begin,
                            double duration) {
  for (int turn = 0;; ++turn) {
    if (!solve_with_friction(problem, trial, begin)) return false;
    if (!model_->has_open_chambers() || !revise_vents(problem, trial, duration)) return true;
    if (turn == kMostVentTurns) {
      failure_ = "fluid and air of an open chamber do not come to agree";
      return false;
    }
  }
}

void Body::update_leaks(double duration, const EquilibriumProblem& problem) {
  if (!model_->has_open_chambers()) return;
  const std::vector<double> flown = outflow_of(duration, problem, state_.equilibrium);
  for (std::size_t k = 0; k < flown.size(); ++k) {
    const int c = model_->openings[k].chamber;
    state_.leaked[c] += flown[k];
    // A given pressure asks for the fluid that the wall then holds.
    if (problem.fluids[c].is_multiplier()) state_.fluid_volume[c] -= flown[k];
  }
  state_.outflow = {.volumes = flown, .step = duration};
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    state_.air[c] = 0;
    if (problem.fluids[c].vent < 0) continue;
    const double held = fluid_held(problem, c, state_.equilibrium);
    const double air = (held - state_.fluid_volume[c]) * state_.volume[c] / held;
    if (air > kNoVolume * std::abs(model_->chambers[c].rest_volume)) state_.air[c] = air;
  }
  measure_openings();
}

double Body::book_leaks(const BodyState& before) {
  if (!model_->has_open_chambers()) return 0;
  double lost = 0;
  for (std::size_t k = 0; k < model_->openings.size(); ++k) {
    const OpeningModel& opening = model_->openings[k];
    const LipState first = lip_state_of(*model_, before, options_.gravity, opening);
    const LipState last = lip_state_of(*model_, state_, options_.gravity, opening);
    const double flown = state_.outflow.volumes[k];
    lost += 0.5 * (first.pressure + last.pressure) * flown;
    lost += flown *
            (carried_energy(*model_, before, opening.chamber) + carried_energy(*model_, state_, opening.chamber)) / 2;
    const Eigen::Matrix3Xd motion = opening.at(state_.equilibrium.position) - opening.at(before.equilibrium.position);
    lost += 0.5 * (first.load + last.load).cwiseProduct(motion).sum();
    const double weight = model_->definition.fluid.density * options_.gravity.dot(0.5 * (first.center + last.center));
    state_.leaked_gravity -= weight * flown;
  }
  for (int c = 0; c < static_cast<int>(model_->chambers.size()); ++c) lost += mixing_loss(before, c);
  return lost;
}

double Body::mixing_loss(const BodyState& before, int chamber) const {
  if (options_.gravity.isZero() || std::max(before.air[chamber], state_.air[chamber]) == 0) return 0;
  // Air comes in at the lips and is at once in all of the contents.
  double area = 0;
  Eigen::Vector3d lips = Eigen::Vector3d::Zero();
  for (const OpeningModel& opening : model_->openings) {
    if (opening.chamber != chamber) continue;
    const Eigen::Matrix3Xd points = opening.at(state_.equilibrium.position);
    lips += points.rowwise().sum();
    area += static_cast<double>(points.cols());
  }
  const Eigen::Vector3d middle =
      first_moments(*model_, state_.equilibrium.position).col(chamber) / state_.volume[chamber] +
      model_->chambers[chamber].level;
  const double density = model_->definition.fluid.density;
  const double mean_density = 0.5 * (density_of(*model_, before, chamber) + density_of(*model_, state_, chamber));
  const double left = mean_density * (state_.volume[chamber] - before.volume[chamber]) -
                      density * (state_.fluid_volume[chamber] - before.fluid_volume[chamber]);
  return -left * options_.gravity.dot(middle - lips / area);
}

}  // namespace thinwall
