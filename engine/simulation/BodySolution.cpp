// How the equilibrium at the end of a step is found: of what presses and rubs and leaks, one within the other.

#include <cmath>
#include <utility>

#include "engine/equilibrium/OpenChambers.hpp"
#include "engine/simulation/Body.hpp"
#include "engine/simulation/Leakage.hpp"
#include "engine/simulation/ToolFriction.hpp"

namespace thinwall {
namespace {

/// Iterations after which a cut body that could creep does so.
constexpr int kMostIterationsBeforeCreeping = 30;

/// Iterations after which an equilibrium that is tried for its energy alone is found with springs.
constexpr int kMostTrialIterations = 20;

/// Iterations within which a solution fails that had a hopeless beginning.
constexpr int kHopelessIterations = 2;

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

}  // namespace

bool Body::solve_step(EquilibriumProblem& problem, EquilibriumState& trial, std::span<const ToolPose> begin,
                      bool goes_on) {
  EquilibriumProblem again = problem;
  const EquilibriumState before = goes_on ? trial : state_.equilibrium;  // that the forces of contacts belong to
  SolveEffort effort;
  if (may_creep()) {
    effort.most_iterations = kMostIterationsBeforeCreeping;
  } else {
    // What may not creep any more, as once the blade has left, no drag slows.
    state_.drag = 0;
  }
  if (trial_tolerance_) effort.most_iterations = kMostTrialIterations;
  const int iterations = report_.newton_iterations;
  // Where a part of the step was found with springs alone those after it are too: without them it takes long to fail.
  // Solutions of one part that differ in friction alone are near each other.
  const bool needs_springs = !goes_on && report_.relaxations > 0 && may_snap() && !may_creep();
  std::optional<WayStart> way;  // where the wall may snap, which must lead it through no tool
  if (may_snap()) way = step_contacts().way(begin, again);
  if (way && goes_on) way = going_on(*way, again, before.position);
  if (state_.drag == 0 && !needs_springs && solve(problem, trial, effort).converged &&
      (!way || !jumped_over_tools(*model_, *way, problem, trial.position))) {
    return true;
  }
  const bool was_hopeless = state_.drag == 0 && report_.newton_iterations - iterations <= kHopelessIterations;
  if (has_inertia() && was_hopeless) {
    // Where its velocity would take it the wall may be beyond its law: the way there begins where it is.
    problem = again;
    trial = state_.equilibrium;
    if (solve(problem, trial, effort).converged) return true;
  }
  if (may_creep()) {
    problem = again;
    return creep(problem, trial, way);
  }
  // Where the wall buckles no short step helps: the equilibrium ends, and the next one is some way off.
  if (!may_snap()) return false;
  trial = before;
  problem = again;
  if (!relax(problem, trial, std::move(way)).converged) return false;
  ++report_.relaxations;
  return true;
}

bool Body::solve_with_friction(EquilibriumProblem& problem, EquilibriumState& trial, std::span<const ToolPose> begin,
                               bool goes_on) {
  FrictionSearch friction(*model_, state_, tools_, begin);
  for (bool again = goes_on;; again = true) {
    const Eigen::VectorXd before = trial.position;
    if (!solve_step(problem, trial, begin, again)) return false;
    const double motion = (trial.position - before).head(3 * model_->vertices()).lpNorm<Eigen::Infinity>();
    if (!friction.revise(problem, trial.position, motion)) return true;
    if (friction.is_hopeless()) {
      failure_ = "friction and pressure of a tool do not come to agree";
      return false;
    }
  }
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
  const Leakage leakage(*model_, state_, options_.gravity, duration);
  for (int turn = 0;; ++turn) {
    if (!solve_with_friction(problem, trial, begin, turn > 0)) return false;
    const bool presses_out = turn >= kMostVentTurns - 1 && report_.halvings >= kHalvingsBeforePressingOut;
    if (!model_->has_open_chambers() || !leakage.revise(problem, newton_->terms(), trial, presses_out)) return true;
    if (turn >= kHastyVentTurns && !draw_air(problem, trial, begin)) return false;
    if (turn == kMostVentTurns) {
      failure_ = "fluid and air of an open chamber do not come to agree";
      return false;
    }
  }
}

}  // namespace thinwall
