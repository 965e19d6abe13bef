#include "engine/simulation/Body.hpp"
#include "engine/simulation/ToolFriction.hpp"

namespace thinwall {
namespace {

/// How a wall is led from an equilibrium that is not stable to one that is: by springs, in units of its stiffness, that
/// tie every vertex to where it was a turn before. In each turn whose springs are little stiffer than it is unstable it
/// goes on by a factor.
struct BucklingPace {
  int most_left = 3;    // equilibria left in a step, one motion each; the next is taken though it is not stable
  int turns = 60;       // at most, from one equilibrium to the next
  int free_turns = 5;   // of so many one is tried without springs
  int iterations = 25;  // of the solution of a turn
  double first_springs = 1e-4;
  double stiffest_springs = 1e2;  // hold so much that a wall which does not follow them goes nowhere
  double weakened = 0.3;          // factor of the springs after a turn that was found
  double stiffened = 4;           // after one that was not
  double lead = 0.7;              // part of the last turn's motion by which the springs lead on
};
constexpr BucklingPace kBuckling = {};

}  // namespace

bool Body::may_buckle(const EquilibriumProblem& problem) const {
  // Inertia holds what motion leaves; flaps of a cut wall, and lips on needles, crumple without end; a hand does not
  // wait.
  const bool may_move = !has_inertia() && !snaps_ && !options_.extrapolates;
  const bool is_whole =
      !state_.cut.has_incised && !state_.cut.has_crumpled && !state_.cut.tool && problem.shafts.empty();
  return !is_convex_ && may_move && is_whole && !model_->has_open_chambers();
}

bool Body::find_buckled(EquilibriumProblem& problem, EquilibriumState& trial) {
  double springs = kBuckling.first_springs;
  Eigen::VectorXd lead = Eigen::VectorXd::Zero(trial.position.size());  // (unknowns), metres
  for (int turn = 1; turn <= kBuckling.turns && springs < kBuckling.stiffest_springs; ++turn) {
    EquilibriumProblem held = problem;
    EquilibriumState next = trial;
    const bool is_free = turn % kBuckling.free_turns == 0;
    if (!is_free) {
      held.inertia = springs * model_->wall_stiffness / model_->mass.mean();
      held.inertia_target = trial.position + lead;
    }
    const bool is_found = solve(held, next, {.most_iterations = kBuckling.iterations}).converged && is_convex_;
    if (is_free && !is_found) continue;
    lead.setZero();
    springs *= is_found ? kBuckling.weakened : kBuckling.stiffened;
    if (!is_found) continue;
    if (!is_free) lead = kBuckling.lead * (next.position - trial.position);
    trial = next;
    problem.attachments = held.attachments;
    problem.solids = held.solids;
    if (is_free) return true;
  }
  return false;
}

void Body::buckle(EquilibriumProblem& problem, EquilibriumState& trial) {
  // Where the step before found no stable equilibrium this one would look for it as long, and in vain. What tools drag
  // along is not found anew on the way.
  const bool may_leave = !is_unstable_ && !has_friction(tools_);
  is_unstable_ = false;
  for (int left = 0; !newton_->is_stable(problem, trial); ++left) {
    EquilibriumProblem next_problem = problem;
    EquilibriumState next = trial;
    const bool was_loose = is_loose_;
    const double residual = report_.residual;
    const bool is_left = may_leave && left < kBuckling.most_left && newton_->leave_saddle(next_problem, next) &&
                         find_buckled(next_problem, next);
    if (!is_left) {
      is_unstable_ = true;
      is_loose_ = was_loose;
      report_.residual = residual;
      break;
    }
    problem = next_problem;
    trial = next;
  }
  is_convex_ = !is_unstable_;
  newton_->look(problem, trial);
}

}  // namespace thinwall
