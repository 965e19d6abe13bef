#include <array>
#include <utility>

#include "engine/equilibrium/LeastMotion.hpp"
#include "engine/equilibrium/Newton.hpp"

// Where parts of a tension field go taut or slack its stiffness jumps from all but nothing to the law's: a step along
// what is slack then ends far up the energy of what it makes taut, and Newton's method goes to and fro. Held more it
// comes to an equilibrium near by, from which it goes on held less, each time from where the last one led.

namespace thinwall {
namespace {

/// Parts of the wall's stiffness by which a slack wall is held on the way, before the one that is asked for.
constexpr std::array<double, 2> kHeldMore = {1e-3, 1e-4};

}  // namespace

NewtonResult Newton::iterate_held(EquilibriumProblem& problem, EquilibriumState& state, const NewtonOptions& options) {
  const Start start = started(problem, state);
  NewtonResult result = iterate(problem, state, options, false);
  const LeastMotion asked = problem.least_motion;
  if (result.converged || !problem.seeks_least_motion() || asked.part >= kHeldMore.back()) return result;
  go_back(start, problem, state);
  int iterations = result.iterations;
  for (const double part : {kHeldMore[0], kHeldMore[1], asked.part}) {
    problem.least_motion = {.part = part, .from = state.position};
    result = iterate(problem, state, options, false);
    iterations += result.iterations;
    if (!result.converged) break;
  }
  problem.least_motion.part = asked.part;
  if (!result.converged) problem.least_motion.from = asked.from;
  result.iterations = iterations;
  return result;
}

}  // namespace thinwall
