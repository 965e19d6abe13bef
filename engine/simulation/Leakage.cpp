#include "engine/simulation/Leakage.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/equilibrium/OpenChambers.hpp"
#include "engine/fluid/LipCap.hpp"
#include "engine/simulation/FluidMotion.hpp"

namespace thinwall {
namespace {

/// Pressure below zero, over the wall's scale of pressure, that counts as none: what the solver leaves is 1e-11 of it.
constexpr double kNoPressure = 1e-9;

/// Volume over the rest volume by which fluid and wall may miss each other: the solver leaves 1e-11 of it.
constexpr double kMissedVolume = 1e-10;

/// Area, over the square of the length of its lips, that an opening counts with at least: those of a fresh cut are
/// closed, and rounding would decide whether there is anything to see the fluid's motion from.
constexpr double kLeastOpening = 1e-12;

/// Pascal: what a balloon of the wall and size bears at unit strain.
double pressure_scale(const BodyModel& model) {
  return model.wall_stiffness / std::sqrt(model.rest_area);
}

/// Metres^2.
double least_area(const Eigen::Matrix3Xd& lips) {
  double length = 0;
  for (Eigen::Index k = 0; k < lips.cols(); ++k) length += (lips.col((k + 1) % lips.cols()) - lips.col(k)).norm();
  return kLeastOpening * length * length;
}

/// Metres^3 that count as none in a chamber.
double no_volume(const BodyModel& model, int chamber) {
  return kMissedVolume * std::abs(model.chambers[chamber].rest_volume);
}

/// Lets all that a chamber holds leave it.
void empty(int opening, FluidProblem& fluid) {
  fluid.vent = opening;
  fluid.fluid_volume = 0;
  fluid.is_empty = fluid.has_surface = true;
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
  if (state.fluid_volume[c] > 0) {
    field = {.slope = model.definition.fluid.density * gravity, .suction = state.air[c] == 0};
    field.at_origin = state.equilibrium.pressure[c] - field.slope.dot(model.chambers[c].level);
  }
  return {.center = cap.center,
          .area = cap.area.norm(),
          .pressure = field.at(cap.center),
          .load = lip_load_of(lips, field) + lip_load_of(lips, pressure_of_inertia(model, state, c))};
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
    const double excess = bulk_pressure_of(state, chamber) - state.reference_pressure[chamber];
    energy -= 0.5 * excess * excess / fluid.bulk_modulus;
  }
  return energy;
}

/// Volume of fluid, as at its reference pressure, that a chamber has room for in a solution, metres^3.
double fluid_held(const EquilibriumProblem& problem, const EquilibriumTerms& terms, int chamber,
                  const EquilibriumState& reached) {
  return terms.volume[chamber] / problem.fluids[chamber].held(reached.pressure[chamber]);
}

/// Whether what has flown before counts at an opening.
bool counts_memory(const BodyModel& model, const EquilibriumProblem& problem, int opening) {
  return !problem.fluids[model.openings[opening].chamber].has_surface;
}

}  // namespace

double Leakage::share(const EquilibriumProblem& problem, int opening) const {
  const bool counts = counts_memory(model_, problem, opening);
  return counts ? state_.outflow.share(static_cast<std::size_t>(opening), duration_) : 0;
}

void Leakage::let_air_in(int chamber, int opening, EquilibriumProblem& problem) const {
  FluidProblem& fluid = problem.fluids[chamber];
  fluid.vent = opening;
  if (gravity_.isZero()) return;
  // From now on the flow alone counts: no part of that before may leave dry lips.
  for (int k = 0; k < static_cast<int>(model_.openings.size()); ++k) {
    if (model_.openings[k].chamber == chamber) fluid.fluid_volume += share(problem, k);
  }
  fluid.outflow_time = duration_;
  fluid.has_surface = true;
  fluid.vent = -1;
}

double Leakage::approach_to(int opening) const {
  const int c = model_.openings[opening].chamber;
  if (state_.fluid_motion.empty() || state_.volume[c] <= 0) return 0;
  const Eigen::Matrix3Xd lips = model_.openings[opening].at(state_.equilibrium.position);
  const Eigen::Vector3d area = lip_cap_of(lips).area;
  if (area.isZero()) return 0;
  const Eigen::Matrix3Xd sweep = lip_load_of(lips, {.at_origin = 1});  // (3 x lips), metres^2
  const double swept = sweep.cwiseProduct(model_.openings[opening].at(state_.velocity)).sum();
  return std::max(0.0, (state_.fluid_motion[c].velocity.dot(area) / state_.volume[c] - swept) / area.norm());
}

void Leakage::add_to(EquilibriumProblem& problem) const {
  if (!model_.has_open_chambers()) return;
  std::vector<int> lowest(problem.fluids.size(), -1);
  std::vector<double> least(problem.fluids.size(), 0);
  problem.approach.assign(model_.openings.size(), 0);
  for (int k = 0; k < static_cast<int>(model_.openings.size()); ++k) {
    const int c = model_.openings[k].chamber;
    FluidProblem& fluid = problem.fluids[c];
    if (!may_leak(model_, c) || !fluid.is_multiplier()) continue;
    fluid.fluid_volume -= share(problem, k);
    fluid.outflow_time = state_.outflow.time(duration_);
    fluid.vent_compliance = std::abs(model_.chambers[c].rest_volume) / pressure_scale(model_);
    if (is_shut(model_, state_.punctures, k)) continue;
    problem.approach[k] = approach_to(k);
    const double pressure = lip_state_of(model_, state_, gravity_, model_.openings[k]).pressure;
    if (lowest[c] < 0 || pressure < least[c]) lowest[c] = k, least[c] = pressure;
  }
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    if (lowest[c] < 0) continue;
    if (at_hand(problem, c) <= no_volume(model_, c)) {
      empty(lowest[c], problem.fluids[c]);
    } else if (state_.air[c] > 0) {
      let_air_in(c, lowest[c], problem);
    }
  }
}

double Leakage::at_hand(const EquilibriumProblem& problem, int chamber) const {
  double whole = problem.fluids[chamber].fluid_volume;
  for (int k = 0; k < static_cast<int>(model_.openings.size()); ++k) {
    if (model_.openings[k].chamber == chamber) whole += share(problem, k);
  }
  return whole;
}

std::vector<double> Leakage::flown(const EquilibriumProblem& problem, const EquilibriumTerms& terms,
                                   const EquilibriumState& reached) const {
  std::vector<double> out(model_.openings.size(), 0);
  if (!model_.has_open_chambers()) return out;
  std::vector<double> left(problem.fluids.size(), 0);  // metres^3, of fluid at the end of the step, before the vent
  for (std::size_t c = 0; c < left.size(); ++c) left[c] = problem.fluids[c].fluid_volume;
  for (int k = 0; k < static_cast<int>(out.size()); ++k) {
    const int c = model_.openings[k].chamber;
    if (!may_leak(model_, c)) continue;
    out[k] = share(problem, k);
    if (problem.fluids[c].vent == k || problem.is_sealed(k)) continue;
    const double time = counts_memory(model_, problem, k) ? state_.outflow.time(duration_) : duration_;
    const double pressure = lip_pressure(model_, problem, terms, k, reached.pressure);
    const double now = time * outflow(model_, problem, k, terms.lips[k].area.norm(), std::max(0.0, pressure)).rate;
    out[k] += now;
    left[c] -= now;
  }
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    const int vent = problem.fluids[c].vent;
    if (vent >= 0) out[vent] = flown_at_vent(problem, terms, c, left[c], reached);
  }
  return out;
}

double Leakage::flown_at_vent(const EquilibriumProblem& problem, const EquilibriumTerms& terms, int chamber,
                              double left, const EquilibriumState& reached) const {
  const FluidProblem& fluid = problem.fluids[chamber];
  if (fluid.is_empty) return state_.fluid_volume[chamber];
  // Where the pressure is zero as much has left as the wall has pressed out, at most what the step before leads to and
  // what goes by itself through lips that draw back.
  const double before = share(problem, fluid.vent);
  const double by_itself =
      state_.outflow.time(duration_) * outflow(model_, problem, fluid.vent, terms.lips[fluid.vent].area.norm(), 0).rate;
  const double most = std::max(0.0, before + (fluid.presses_out ? left : std::min(by_itself, left)));
  return std::clamp(before + left - fluid_held(problem, terms, chamber, reached), 0.0, most);
}

double Leakage::remaining(const EquilibriumProblem& problem, const EquilibriumTerms& terms, int chamber,
                          const EquilibriumState& reached) const {
  const std::vector<double> out = flown(problem, terms, reached);
  double left = problem.fluids[chamber].fluid_volume;
  for (int k = 0; k < static_cast<int>(out.size()); ++k) {
    if (model_.openings[k].chamber == chamber) left -= out[k] - share(problem, k);
  }
  return left;
}

bool Leakage::revise(EquilibriumProblem& problem, const EquilibriumTerms& terms, const EquilibriumState& reached,
                     bool presses_out) const {
  bool revised = false;
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    FluidProblem& fluid = problem.fluids[c];
    if (!may_leak(model_, c) || !fluid.is_multiplier() || fluid.is_empty) continue;
    int lowest = -1;
    double pressure = std::numeric_limits<double>::infinity();
    for (int k = 0; k < static_cast<int>(model_.openings.size()); ++k) {
      if (model_.openings[k].chamber != c || problem.is_sealed(k)) continue;
      const double at_lips = lip_pressure(model_, problem, terms, k, reached.pressure);
      if (at_lips < pressure) lowest = k, pressure = at_lips;
    }
    const bool draws = !fluid.has_surface && pressure < -kNoPressure * pressure_scale(model_);
    const double none = no_volume(model_, c), left = remaining(problem, terms, c, reached);
    const double missing = fluid.vent >= 0 ? fluid_held(problem, terms, c, reached) - left : 0;
    const bool is_too_full = missing < -none;
    const bool takes_air = missing > none && !gravity_.isZero();
    if (draws) {
      fluid.vent = lowest;
    } else if (lowest >= 0 && left <= none) {
      empty(lowest, fluid);
    } else if (fluid.has_surface || (!is_too_full && !takes_air)) {
      continue;  // under a surface all that may be is: air above, none, and lips that are dry or not
    } else if (takes_air) {
      let_air_in(c, fluid.vent, problem);
    } else if (presses_out) {
      fluid.presses_out = true;
      continue;
    } else {
      fluid.vent = -1;
    }
    revised = true;
  }
  return revised;
}

void start_leaks(const BodyModel& model, BodyState& state) {
  const auto chambers = static_cast<Eigen::Index>(model.chambers.size());
  state.leaked = state.air = Eigen::VectorXd::Zero(chambers);
  state.outflow = {};
  measure_openings(model, state);
}

void measure_openings(const BodyModel& model, BodyState& state) {
  state.open_area.resize(static_cast<Eigen::Index>(model.openings.size()));
  for (std::size_t k = 0; k < model.openings.size(); ++k) {
    const Eigen::Matrix3Xd lips = model.openings[k].at(state.equilibrium.position);
    const double area = std::max(lip_cap_of(lips).area.norm(), least_area(lips));
    state.open_area[static_cast<Eigen::Index>(k)] = is_shut(model, state.punctures, static_cast<int>(k)) ? 0 : area;
  }
}

void leak(const BodyModel& model, const Eigen::Vector3d& gravity, double duration, const EquilibriumProblem& problem,
          const EquilibriumTerms& terms, BodyState& state) {
  if (!model.has_open_chambers()) {
    measure_openings(model, state);
    return;
  }
  const std::vector<double> flown = Leakage(model, state, gravity, duration).flown(problem, terms, state.equilibrium);
  for (std::size_t k = 0; k < flown.size(); ++k) {
    const int c = model.openings[k].chamber;
    state.leaked[c] += flown[k];
    // A given pressure asks for the fluid that the wall then holds.
    if (problem.fluids[c].is_multiplier()) state.fluid_volume[c] -= flown[k];
  }
  state.outflow = {.volumes = flown, .step = duration};
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    state.air[c] = 0;
    if (problem.fluids[c].vent < 0 && !problem.fluids[c].has_surface) continue;
    const double held = fluid_held(problem, terms, c, state.equilibrium);
    const double air = (held - state.fluid_volume[c]) * state.volume[c] / held;
    if (air > no_volume(model, c)) state.air[c] = air;
  }
  measure_openings(model, state);
}

double book_leaks(const BodyModel& model, const Eigen::Vector3d& gravity, const BodyState& before, BodyState& state) {
  if (!model.has_open_chambers() || !model.definition.fluid.leaks) return 0;
  double lost = 0;
  for (std::size_t k = 0; k < model.openings.size(); ++k) {
    const OpeningModel& opening = model.openings[k];
    const LipState first = lip_state_of(model, before, gravity, opening);
    const LipState last = lip_state_of(model, state, gravity, opening);
    const double flown = state.outflow.volumes[k];
    lost += 0.5 * (first.pressure + last.pressure) * flown;
    // What empties a chamber is the last that goes.
    const BodyState& after = state.fluid_volume[opening.chamber] > 0 ? state : before;
    lost +=
        flown * (carried_energy(model, before, opening.chamber) + carried_energy(model, after, opening.chamber)) / 2;
    const Eigen::Matrix3Xd motion = opening.at(state.equilibrium.position) - opening.at(before.equilibrium.position);
    // What fills an opening lets no jet through: the fluid presses on it as on a piston, and spends nothing.
    const bool is_open = !is_shut(model, state.punctures, static_cast<int>(k));
    if (is_open) lost += 0.5 * (first.load + last.load).cwiseProduct(motion).sum();
    const double weight = model.definition.fluid.density * gravity.dot(0.5 * (first.center + last.center));
    state.leaked_gravity -= weight * flown;
  }
  return lost;
}

}  // namespace thinwall
