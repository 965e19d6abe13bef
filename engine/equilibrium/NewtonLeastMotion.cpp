#include <algorithm>
#include <array>

#include "engine/equilibrium/LeastMotion.hpp"
#include "engine/equilibrium/Newton.hpp"

// Where parts of a tension field go taut or slack its stiffness jumps from all but nothing to the law's: a step along
// what is slack then ends far up the energy of what it makes taut, and Newton's method goes to and fro. Held more it
// comes to an equilibrium near by, from which it goes on held less, each time from where the last one led.

namespace thinwall {
namespace {

/// Parts of the wall's stiffness by which a slack wall is held on the way, before the one that is asked for.
constexpr std::array<double, 2> kHeldMore = {1e-3, 1e-4};

/// Iterations without that before it is tried, and in all with it from which on the next solution begins so.
constexpr int kMostUnheld = 30;
constexpr int kManyHeld = 30;

}  // namespace

NewtonResult Newton::iterate_held(EquilibriumProblem& problem, EquilibriumState& state, const NewtonOptions& options) {
  const LeastMotion asked = problem.least_motion;
  if (!problem.seeks_least_motion() || asked.part >= kHeldMore.back()) return iterate(problem, state, options, false);
  int iterations = 0;
  if (!begins_held_) {
    const Start start = started(problem, state);
    NewtonOptions unheld = options;
    unheld.maximum_iterations = std::min(options.maximum_iterations, kMostUnheld);
    NewtonResult result = iterate(problem, state, unheld, false);
    if (result.converged) return result;
    iterations = result.iterations;
    go_back(start, problem, state);
  }
  NewtonResult result;
  int held = 0;
  for (const double part : {kHeldMore[0], kHeldMore[1], asked.part}) {
    problem.least_motion = {.part = part, .from = state.position};
    result = iterate(problem, state, options, false);
    held += result.iterations;
    if (!result.converged) break;
  }
  begins_held_ = result.converged && held >= kManyHeld;
  problem.least_motion.part = asked.part;
  if (!result.converged) problem.least_motion.from = asked.from;
  result.iterations = iterations + held;
  return result;
}

}  // namespace thinwall
