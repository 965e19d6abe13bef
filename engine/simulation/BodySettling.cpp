#include <cmath>
#include <sstream>

#include "engine/simulation/Body.hpp"
#include "engine/simulation/SimulationFailure.hpp"

namespace thinwall {
namespace {

/// How often `relax` solves with springs before it gives up.
constexpr int kRelaxationTurns = 100;

/// Multiple of the rest volume beyond which a body under a given pressure has burst: past its limit point a wall under
/// constant pressure grows without end.
constexpr double kBurstVolume = 30;

}  // namespace

NewtonResult Body::solve(EquilibriumProblem& problem, EquilibriumState& state) {
  const NewtonResult result = newton_.solve(
      problem, state, {.tolerance = options_.tolerance, .maximum_iterations = options_.maximum_iterations});
  report_.newton_iterations += result.iterations;
  report_.shifted_iterations += result.shifted_iterations;
  report_.residual = result.residual;
  failure_ = result.reason;
  return result;
}

NewtonResult Body::relax(EquilibriumProblem& problem, EquilibriumState& state) {
  // Pseudo-inertia: springs, in units of the wall's stiffness, tie every vertex to where it is. A slack or a buckling
  // wall has directions without stiffness in which Newton's steps make no sense; the springs give them some, and are
  // weakened as long as the solution follows.
  double springs = 1;
  for (int turn = 0; turn < kRelaxationTurns; ++turn) {
    EquilibriumState trial = state;
    EquilibriumProblem held = problem;
    held.inertia = springs * model_->wall_stiffness / model_->mass.mean();
    held.inertia_target = state.position;
    if (solve(held, trial).converged) {
      state = trial;
      problem.attachments = held.attachments;
      problem.spheres = held.spheres;
      springs *= 0.25;
    } else {
      springs *= 8;
    }
    if (std::abs(enclosed_volume(*model_, state.position)) > kBurstVolume * model_->rest_volume) break;
    if (springs < 1e-3 && turn % 4 == 3) {
      trial = state;
      held = problem;
      const NewtonResult result = solve(held, trial);
      if (!result.converged) continue;
      state = trial;
      problem = held;
      return result;
    }
  }
  NewtonResult failed;
  failed.reason = "no equilibrium was found, also with pseudo-inertia";
  failure_ = failed.reason;
  return failed;
}

void Body::solve_statics(double pressure, FluidMode mode) {
  EquilibriumProblem problem;
  problem.fluid = mode;
  problem.pressure = pressure;
  problem.fluid_volume = model_->rest_volume;
  problem.bulk_modulus = model_->definition.fluid.bulk_modulus;
  problem.hold_rigid_motions = model_->rigid_motions.cols() > 0;
  EquilibriumProblem again = problem;
  EquilibriumState trial = state_.equilibrium;
  if (!solve(problem, trial).converged) {
    trial = state_.equilibrium;
    if (!relax(again, trial).converged) {
      std::ostringstream message;
      message << "body `" << model_->definition.name << "`, equilibrium before time zero";
      if (mode == FluidMode::kGivenPressure) message << " under " << pressure << " Pa";
      message << ": " << failure_
              << "; a wall holds only so much pressure: take a lower one, or a thicker or stiffer wall";
      throw SimulationFailure(message.str());
    }
  }
  state_.equilibrium = trial;
}

void Body::settle() {
  const FluidDefinition& fluid = model_->definition.fluid;
  if (!model_->has_fluid()) {
    solve_statics(0, FluidMode::kNone);
  } else if (fluid.initial_pressure) {
    solve_statics(*fluid.initial_pressure, FluidMode::kGivenPressure);
  } else {
    solve_statics(0, fluid_mode());
  }
  state_.volume = enclosed_volume(*model_, state_.equilibrium.position);
  state_.fluid_volume = fluid.initial_pressure ? state_.volume : model_->rest_volume;
  state_.reference_pressure = fluid.initial_pressure.value_or(0);
  state_.previous_position = state_.equilibrium.position;
  state_.static_force = newton_.terms().gradient - state_.equilibrium.pressure * newton_.terms().volume_gradient;
  state_.books.elastic = newton_.terms().elastic;
  state_.books.fluid = fluid_energy(*model_, state_);
  state_.books.script_work = state_.books.stored();
}

}  // namespace thinwall
