// What runs out of a body through openings of its wall, and the air that comes in.
//
// Fluid leaves by FlowMemory's rule, seen from the lips: those that draw back over it let it out without pressure. A
// chamber ends each step in one of three states: filled, with a pressure at its openings that is not negative; drained,
// where the pressure at the highest opening is zero and as much has left as the wall has pressed out; or with air that
// came in there. Without gravity the pressure is then zero and the volume free; under gravity the air lies above the
// fluid, see OpenChambers, and fluid leaves through lips that are below its surface. A chamber with nothing left in it
// is empty, whatever wall and caps enclose: less than nothing where a wall is turned inside out. States are tried until
// one holds. In a filled chamber fluid may hang from the wall under suction, as below an opening at the bottom; air
// that has come in ends that.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/equilibrium/OpenChambers.hpp"
#include "engine/fluid/FluidWeight.hpp"
#include "engine/simulation/Body.hpp"

namespace thinwall {
namespace {

/// Times within a step that chambers may turn from filled to aired and back.
constexpr int kMostVentTurns = 6;

/// Of these, the first ones that let the pressure go to zero at once. A wall that buckles may then jump to a shape that
/// presses fluid out, and back from that to the one that draws. What there is to be found is a shape further out: the
/// volume is made larger part by part until the wall draws no more.
constexpr int kHastyVentTurns = 1;
constexpr double kAirPart = 0.01;  // of the rest volume
constexpr int kMostAirParts = 40;

/// Halvings of the step after which a chamber that turns from filled to drained and back all the same is drained: the
/// wall snaps there, and what it has no room for any more leaves at once.
constexpr int kHalvingsBeforePressingOut = 4;

/// Pressure below zero, over the wall's scale of pressure, that counts as none: what the solver leaves is 1e-11 of it.
constexpr double kNoPressure = 1e-9;

/// Volume over the rest volume by which fluid and wall may miss each other: the solver leaves 1e-11 of it.
constexpr double kNoVolume = 1e-10;

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
  return kNoVolume * std::abs(model.chambers[chamber].rest_volume);
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

}  // namespace

void Body::start_leaks() {
  const auto chambers = static_cast<Eigen::Index>(model_->chambers.size());
  state_.leaked = state_.air = Eigen::VectorXd::Zero(chambers);
  state_.outflow = {};
  measure_openings();
}

void Body::measure_openings() {
  state_.open_area.resize(static_cast<Eigen::Index>(model_->openings.size()));
  for (std::size_t k = 0; k < model_->openings.size(); ++k) {
    const Eigen::Matrix3Xd lips = model_->openings[k].at(state_.equilibrium.position);
    const double area = std::max(lip_cap_of(lips).area.norm(), least_area(lips));
    state_.open_area[static_cast<Eigen::Index>(k)] = is_sealed(static_cast<int>(k)) ? 0 : area;
  }
}

bool Body::counts_memory(const EquilibriumProblem& problem, int opening) const {
  return !problem.fluids[model_->openings[opening].chamber].has_surface;
}

double Body::outflow_share(const EquilibriumProblem& problem, int opening, double duration) const {
  return counts_memory(problem, opening) ? state_.outflow.share(static_cast<std::size_t>(opening), duration) : 0;
}

void Body::let_air_in(int chamber, int opening, double duration, EquilibriumProblem& problem) const {
  FluidProblem& fluid = problem.fluids[chamber];
  fluid.vent = opening;
  if (options_.gravity.isZero()) return;
  // From now on the flow alone counts: no part of that before may leave dry lips.
  for (int k = 0; k < static_cast<int>(model_->openings.size()); ++k) {
    if (model_->openings[k].chamber == chamber) fluid.fluid_volume += outflow_share(problem, k, duration);
  }
  fluid.outflow_time = duration;
  fluid.has_surface = true;
  fluid.vent = -1;
}

double Body::approach_to(int opening) const {
  const int c = model_->openings[opening].chamber;
  if (state_.fluid_motion.empty() || state_.volume[c] <= 0) return 0;
  const Eigen::Matrix3Xd lips = model_->openings[opening].at(state_.equilibrium.position);
  const Eigen::Vector3d area = lip_cap_of(lips).area;
  if (area.isZero()) return 0;
  const Eigen::Matrix3Xd sweep = lip_load_of(lips, {.at_origin = 1});  // (3 x lips), metres^2
  const double swept = sweep.cwiseProduct(model_->openings[opening].at(state_.velocity)).sum();
  return std::max(0.0, (state_.fluid_motion[c].velocity.dot(area) / state_.volume[c] - swept) / area.norm());
}

void Body::add_leaks(double duration, EquilibriumProblem& problem) const {
  if (!model_->has_open_chambers()) return;
  std::vector<int> lowest(problem.fluids.size(), -1);
  std::vector<double> least(problem.fluids.size(), 0);
  problem.approach.assign(model_->openings.size(), 0);
  for (int k = 0; k < static_cast<int>(model_->openings.size()); ++k) {
    const int c = model_->openings[k].chamber;
    FluidProblem& fluid = problem.fluids[c];
    if (!may_leak(*model_, c) || !fluid.is_multiplier()) continue;
    fluid.fluid_volume -= outflow_share(problem, k, duration);
    fluid.outflow_time = state_.outflow.time(duration);
    fluid.vent_compliance = std::abs(model_->chambers[c].rest_volume) / pressure_scale(*model_);
    if (is_sealed(k)) continue;
    problem.approach[k] = approach_to(k);
    const double pressure = lip_state_of(*model_, state_, options_.gravity, model_->openings[k]).pressure;
    if (lowest[c] < 0 || pressure < least[c]) lowest[c] = k, least[c] = pressure;
  }
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    if (lowest[c] < 0) continue;
    if (fluid_at_hand(problem, c, duration) <= no_volume(*model_, c)) {
      empty(lowest[c], problem.fluids[c]);
    } else if (state_.air[c] > 0) {
      let_air_in(c, lowest[c], duration, problem);
    }
  }
}

double Body::fluid_at_hand(const EquilibriumProblem& problem, int chamber, double duration) const {
  double whole = problem.fluids[chamber].fluid_volume;
  for (int k = 0; k < static_cast<int>(model_->openings.size()); ++k) {
    if (model_->openings[k].chamber == chamber) whole += outflow_share(problem, k, duration);
  }
  return whole;
}

std::vector<double> Body::outflow_of(double duration, const EquilibriumProblem& problem,
                                     const EquilibriumState& reached) const {
  std::vector<double> flown(model_->openings.size(), 0);
  if (!model_->has_open_chambers()) return flown;
  const EquilibriumTerms& terms = newton_->terms();
  std::vector<double> left(problem.fluids.size(), 0);  // metres^3, of fluid at the end of the step, before the vent
  for (std::size_t c = 0; c < left.size(); ++c) left[c] = problem.fluids[c].fluid_volume;
  for (int k = 0; k < static_cast<int>(flown.size()); ++k) {
    const int c = model_->openings[k].chamber;
    if (!may_leak(*model_, c)) continue;
    flown[k] = outflow_share(problem, k, duration);
    if (problem.fluids[c].vent == k || problem.is_sealed(k)) continue;
    const double time = counts_memory(problem, k) ? state_.outflow.time(duration) : duration;
    const double pressure = lip_pressure(*model_, problem, terms, k, reached.pressure);
    const double now = time * outflow(*model_, problem, k, terms.lips[k].area.norm(), std::max(0.0, pressure)).rate;
    flown[k] += now;
    left[c] -= now;
  }
  // Where the pressure is zero as much has left as the wall has pressed out, at most what the step before leads to and
  // what goes by itself through lips that draw back.
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    const int vent = problem.fluids[c].vent;
    if (vent < 0) continue;
    if (problem.fluids[c].is_empty) {
      flown[vent] = state_.fluid_volume[c];
      continue;
    }
    const double share = outflow_share(problem, vent, duration);
    const double by_itself =
        state_.outflow.time(duration) * outflow(*model_, problem, vent, terms.lips[vent].area.norm(), 0).rate;
    const double most = std::max(0.0, share + (problem.fluids[c].presses_out ? left[c] : std::min(by_itself, left[c])));
    flown[vent] = std::clamp(share + left[c] - fluid_held(problem, c, reached), 0.0, most);
  }
  return flown;
}

double Body::fluid_held(const EquilibriumProblem& problem, int chamber, const EquilibriumState& reached) const {
  const FluidProblem& fluid = problem.fluids[chamber];
  return newton_->terms().volume[chamber] / fluid.held(reached.pressure[chamber]);
}

double Body::fluid_left(const EquilibriumProblem& problem, int chamber, const EquilibriumState& reached,
                        double duration) const {
  const std::vector<double> flown = outflow_of(duration, problem, reached);
  double left = problem.fluids[chamber].fluid_volume;
  for (int k = 0; k < static_cast<int>(flown.size()); ++k) {
    if (model_->openings[k].chamber == chamber) left -= flown[k] - outflow_share(problem, k, duration);
  }
  return left;
}

bool Body::revise_vents(EquilibriumProblem& problem, const EquilibriumState& reached, double duration, int turn) const {
  const bool goes_in_circles = turn >= kMostVentTurns - 1 && report_.halvings >= kHalvingsBeforePressingOut;
  bool revised = false;
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    FluidProblem& fluid = problem.fluids[c];
    if (!may_leak(*model_, c) || !fluid.is_multiplier() || fluid.is_empty) continue;
    int lowest = -1;
    double pressure = std::numeric_limits<double>::infinity();
    for (int k = 0; k < static_cast<int>(model_->openings.size()); ++k) {
      if (model_->openings[k].chamber != c || problem.is_sealed(k)) continue;
      const double at_lips = lip_pressure(*model_, problem, newton_->terms(), k, reached.pressure);
      if (at_lips < pressure) lowest = k, pressure = at_lips;
    }
    const bool draws = !fluid.has_surface && pressure < -kNoPressure * pressure_scale(*model_);
    const double none = no_volume(*model_, c), left = fluid_left(problem, c, reached, duration);
    const double missing = fluid.vent >= 0 ? fluid_held(problem, c, reached) - left : 0;
    const bool is_too_full = missing < -none;
    const bool takes_air = missing > none && !options_.gravity.isZero();
    if (draws) {
      fluid.vent = lowest;
    } else if (lowest >= 0 && left <= none) {
      empty(lowest, fluid);
    } else if (fluid.has_surface || (!is_too_full && !takes_air)) {
      continue;  // under a surface all that may be is: air above, none, and lips that are dry or not
    } else if (takes_air) {
      let_air_in(c, fluid.vent, duration, problem);
    } else if (goes_in_circles) {
      fluid.presses_out = true;
      continue;
    } else {
      fluid.vent = -1;
    }
    revised = true;
  }
  return revised;
}

bool Body::draw_air(EquilibriumProblem& problem, EquilibriumState& trial, std::span<const ToolPose> begin) {
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    FluidProblem& fluid = problem.fluids[c];
    const int vent = fluid.vent;
    if (vent < 0) continue;
    const FluidProblem whole = fluid;
    const auto at_lips = [&] { return lip_pressure(*model_, problem, newton_->terms(), vent, trial.pressure); };
    fluid.vent = -1;
    for (int part = 0; part < kMostAirParts && at_lips() < 0; ++part) {
      fluid.fluid_volume += kAirPart * std::abs(model_->chambers[c].rest_volume);
      if (!solve_with_friction(problem, trial, begin, true)) return false;
    }
    fluid = whole;
  }
  return true;
}

bool Body::solve_with_leaks(EquilibriumProblem& problem, EquilibriumState& trial, std::span<const ToolPose> begin,
                            double duration) {
  for (int turn = 0;; ++turn) {
    if (!solve_with_friction(problem, trial, begin, turn > 0)) return false;
    if (!model_->has_open_chambers() || !revise_vents(problem, trial, duration, turn)) return true;
    if (turn >= kHastyVentTurns && !draw_air(problem, trial, begin)) return false;
    if (turn == kMostVentTurns) {
      failure_ = "fluid and air of an open chamber do not come to agree";
      return false;
    }
  }
}

void Body::update_leaks(double duration, const EquilibriumProblem& problem) {
  if (!model_->has_open_chambers()) {
    measure_openings();
    return;
  }
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
    if (problem.fluids[c].vent < 0 && !problem.fluids[c].has_surface) continue;
    const double held = fluid_held(problem, c, state_.equilibrium);
    const double air = (held - state_.fluid_volume[c]) * state_.volume[c] / held;
    if (air > no_volume(*model_, c)) state_.air[c] = air;
  }
  measure_openings();
}

double Body::book_leaks(const BodyState& before) {
  if (!model_->has_open_chambers() || !model_->definition.fluid.leaks) return 0;
  double lost = 0;
  for (std::size_t k = 0; k < model_->openings.size(); ++k) {
    const OpeningModel& opening = model_->openings[k];
    const LipState first = lip_state_of(*model_, before, options_.gravity, opening);
    const LipState last = lip_state_of(*model_, state_, options_.gravity, opening);
    const double flown = state_.outflow.volumes[k];
    lost += 0.5 * (first.pressure + last.pressure) * flown;
    // What empties a chamber is the last that goes.
    const BodyState& after = state_.fluid_volume[opening.chamber] > 0 ? state_ : before;
    lost += flown *
            (carried_energy(*model_, before, opening.chamber) + carried_energy(*model_, after, opening.chamber)) / 2;
    const Eigen::Matrix3Xd motion = opening.at(state_.equilibrium.position) - opening.at(before.equilibrium.position);
    // What fills an opening lets no jet through: the fluid presses on it as on a piston, and spends nothing.
    if (!is_sealed(static_cast<int>(k))) lost += 0.5 * (first.load + last.load).cwiseProduct(motion).sum();
    const double weight = model_->definition.fluid.density * options_.gravity.dot(0.5 * (first.center + last.center));
    state_.leaked_gravity -= weight * flown;
  }
  return lost;
}

}  // namespace thinwall
