#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include "engine/simulation/Body.hpp"
#include "engine/simulation/Leakage.hpp"
#include "engine/simulation/SimulationFailure.hpp"

namespace thinwall {
namespace {

/// How `relax` goes on.
struct RelaxationPace {
  int turns = 0;            // how often it solves with springs before it gives up
  SolveEffort effort = {};  // of a solution on the way
  int easy_iterations = 0;  // up to which springs are weakened after a solution
  double weakened = 0;      // factor by which they are
  double stiffened = 0;     // factor by which they are made stiffer after none
  double lead = 0;          // part of the last turn's motion by which the springs of the next lead on
};

/// Where tools press: every solution on the way is one.
constexpr RelaxationPace kCareful = {.turns = 100,
                                     .effort = {.takes_flaps = true},
                                     .easy_iterations = std::numeric_limits<int>::max(),
                                     .weakened = 0.25,
                                     .stiffened = 8};

/// At the start: on its way no solution needs to be exact, nor to be found at any cost. With springs that do not lead
/// on, a wall of an organ that buckles under its pressure takes three times as many iterations; with a larger part it
/// runs past.
constexpr RelaxationPace kEager = {.turns = 300,
                                   .effort = {.most_iterations = 25, .tolerance = 1e-3, .takes_flaps = true},
                                   .easy_iterations = 10,
                                   .weakened = 0.4,
                                   .stiffened = 4,
                                   .lead = 0.7};

/// Iterations of a solution with springs after which the wall is taken to buckle, so that the next one does not try
/// steps without line search first.
constexpr int kBucklingIterations = 6;

/// Part of the volume by which a solution that was not found may have changed it for where it came to be taken: a
/// longer way may lead past the equilibrium of a wall that would burst beyond it.
constexpr double kNear = 0.15;

/// Springs below which a body may find its equilibrium without any.
constexpr double kWeakSprings = 1e-3;

/// Springs that hold so much that a body which does not even follow them has no equilibrium at hand.
constexpr double kStiffestSprings = 1e4;

/// The same of a cut wall that is slack: with what it begins, what is too much, by how much it is eased from step to
/// step, and below what it is none.
constexpr double kFirstDrag = 1e-3;
constexpr double kMostDrag = 1e2;
constexpr double kEasedDrag = 0.25;
constexpr double kLeastDrag = 1e-5;

/// What is too much after so many halvings of a step: it holds a wall alike in a long step and in a short one, so that
/// to halve the step on helps no more.
constexpr double kHoldingDrag = 1e4;
constexpr int kHalvingsBeforeHolding = 6;

/// Iterations after which stronger springs are cheaper, and up to which they are eased.
constexpr int kMostDraggedIterations = 20;
constexpr int kEasyIterations = 8;

/// Halvings of a step in motion after which equilibria are taken that are not stable: where a wall buckles faster than
/// steps can tell, the way that it is on leads on through such ones until it has left it.
constexpr int kHalvingsBeforeSaddles = 4;

/// Parts in which the weight is put on where it cannot be at once.
constexpr int kWeightParts = 8;

/// Multiple of its volume from which on a body in motion that cannot be solved is taken to burst.
constexpr double kBlownUpVolume = 3;

/// Pseudo-inertia: springs, in units of the wall's stiffness, tie every vertex to a target, (unknowns), metres. A slack
/// or a buckling wall has directions without stiffness in which Newton's steps make no sense; the springs give them
/// some, and are weakened as long as the solution follows.
EquilibriumProblem held_by_springs(const BodyModel& model, const EquilibriumProblem& problem, double springs,
                                   Eigen::VectorXd target) {
  EquilibriumProblem held = problem;
  held.inertia = springs * model.wall_stiffness / model.mass.mean();
  held.inertia_target = std::move(target);
  return held;
}

/// Goes on from a solution with springs.
void take(const EquilibriumProblem& held, const EquilibriumState& trial, EquilibriumProblem& problem,
          EquilibriumState& state) {
  state = trial;
  problem.least_motion.from = state.position;
  problem.attachments = held.attachments;
  problem.solids = held.solids;
}

/// Whether a solution leads through no tool at once, where that is asked of it.
bool went_around(const BodyModel& model, const std::optional<WayStart>& way, const EquilibriumProblem& problem,
                 const EquilibriumState& reached) {
  return !way || !jumped_over_tools(model, *way, problem, reached.position);
}

bool stays_near(const BodyModel& model, const EquilibriumState& before, const EquilibriumState& after) {
  if (!model.has_fluid()) return true;
  const double volume = enclosed_volumes(model, before.position).sum();
  return std::abs(enclosed_volumes(model, after.position).sum() - volume) <= kNear * std::abs(volume);
}

}  // namespace

NewtonResult Body::solve(EquilibriumProblem& problem, EquilibriumState& state, const SolveEffort& effort) {
  const int most = options_.maximum_iterations;
  const CutProgress& cut = state_.cut;
  const bool buckles = has_inertia() && report_.halvings >= kHalvingsBeforeSaddles;
  const bool takes_flaps = effort.takes_flaps || cut.has_incised || cut.has_crumpled || cut.tool || buckles;
  const double tolerance = trial_tolerance_.value_or(options_.tolerance);
  NewtonResult result = newton_->solve(problem, state,
                                       {.tolerance = std::max(effort.tolerance.value_or(0), tolerance),
                                        .maximum_iterations = std::min(effort.most_iterations.value_or(most), most),
                                        .takes_flaps = takes_flaps,
                                        .borders_contacts = options_.extrapolates,
                                        .buckles = effort.buckles,
                                        .between_iterations = options_.between_iterations});
  report_.newton_iterations += result.iterations;
  report_.factorisations += result.factorisations;
  report_.shifted_iterations += result.shifted_iterations;
  report_.ascending_steps += result.ascending_steps;
  report_.residual = result.residual;
  if (result.converged) {
    report_.residual_share = std::max(report_.residual_share, result.residual / result.force_scale);
  }
  is_loose_ = result.converged && result.is_loose;
  // What rests already is as stable as it was.
  if (!result.converged || result.iterations > 0) is_convex_ = !result.converged || result.is_convex;
  failure_ = result.reason;
  return result;
}

NewtonResult Body::fail(const std::string& reason) {
  NewtonResult failed;
  failed.reason = failure_ = reason;
  return failed;
}

std::optional<NewtonResult> Body::rest_without_springs(EquilibriumProblem& problem, EquilibriumState& state,
                                                       const std::optional<WayStart>& way, const NewtonResult* held) {
  EquilibriumState trial = state;
  EquilibriumProblem let_go = problem;
  NewtonResult result = solve(let_go, trial, {.takes_flaps = true});
  if (result.converged && went_around(*model_, way, let_go, trial)) {
    state = trial;
    problem = let_go;
    return result;
  }
  if (held == nullptr || !leaves_rest_to_steps()) return std::nullopt;
  // What the springs still hold back is missed of an equilibrium without them.
  report_.residual = newton_->missed(problem, state);
  is_loose_ = true;
  return *held;
}

NewtonResult Body::relax(EquilibriumProblem& problem, EquilibriumState& state, std::optional<WayStart> way,
                         bool is_eager) {
  const RelaxationPace& pace = is_eager ? kEager : kCareful;
  const std::string before = failure_;
  double springs = 1;
  bool buckles = false;  // whether the last solution was hard
  Growth growth = growth_from(problem, state);
  Eigen::VectorXd lead = Eigen::VectorXd::Zero(state.position.size());  // (unknowns), metres
  for (int turn = 0; turn < pace.turns; ++turn) {
    EquilibriumState trial = state;
    EquilibriumProblem held = held_by_springs(*model_, problem, springs, state.position + lead);
    const bool is_on_the_way = springs >= kWeakSprings;
    SolveEffort effort = is_on_the_way ? pace.effort : SolveEffort{.takes_flaps = true};
    effort.buckles = is_eager && buckles;
    NewtonResult held_result = solve(held, trial, effort);
    buckles = held_result.iterations > kBucklingIterations;
    const bool is_taken = held_result.converged && went_around(*model_, way, held, trial);
    if (is_taken) {
      lead = pace.lead * (trial.position - state.position);
      take(held, trial, problem, state);
      if (way) way = going_on(*way, problem, state.position);
      // What such weak springs hold back is no energy that matters.
      if (trial_tolerance_ && springs < kWeakSprings) return held_result;
      if (held_result.iterations <= pace.easy_iterations || !is_on_the_way) springs *= pace.weakened;
    } else {
      // With springs the search went down all the same.
      if (is_eager && stays_near(*model_, state, trial)) take(held, trial, problem, state);
      lead.setZero();
      springs *= pace.stiffened;
      if (springs > kStiffestSprings) break;
    }
    if (const auto burst = burst_of(growth, problem, state)) return *burst;
    if (springs < kWeakSprings && turn % 4 == 3) {
      const auto result = rest_without_springs(problem, state, way, is_taken ? &held_result : nullptr);
      if (result) return *result;
    }
  }
  // The last solution with springs may have been good, and without them not at hand all the same.
  const std::string& reason = failure_.empty() ? before : failure_;
  return fail(reason.empty() ? "no convergence without pseudo-inertia" : reason + ", also with pseudo-inertia");
}

bool Body::creep(EquilibriumProblem& problem, EquilibriumState& trial, const std::optional<WayStart>& way) {
  // A wall that has been cut and lost its contents may go slack altogether: it then has no equilibrium that anything
  // but its own inertia chooses. Springs to where it was slow it down, as a viscous bath would: it creeps to where it
  // can rest, over as many steps as that takes, and the springs are eased from step to step. In motion they slow down
  // flaps that flutter faster than steps can tell. What they take up counts as spent by the integrator.
  const EquilibriumProblem whole = problem;
  const double most = report_.halvings < kHalvingsBeforeHolding ? kMostDrag : kHoldingDrag;
  for (double drag = state_.drag > 0 ? state_.drag : kFirstDrag; drag < most; drag *= 8) {
    trial = state_.equilibrium;
    EquilibriumProblem held = whole;
    const double springs = drag * model_->wall_stiffness / model_->mass.mean();
    held.inertia += springs;
    held.inertia_target = springs / held.inertia * state_.equilibrium.position;
    if (whole.inertia > 0) held.inertia_target += whole.inertia / held.inertia * whole.inertia_target;
    state_.drag = drag;
    const NewtonResult result = solve(held, trial, {.most_iterations = kMostDraggedIterations});
    if (!result.converged || !went_around(*model_, way, held, trial)) continue;
    state_.drag_eases = result.iterations <= kEasyIterations;
    problem = held;
    problem.inertia = whole.inertia;
    problem.inertia_target = whole.inertia_target;
    return true;
  }
  return false;
}

void Body::find_drag(const Eigen::VectorXd& before) {
  state_.drag_force.resize(0);
  if (state_.drag == 0) return;
  const double stiffness = state_.drag * model_->wall_stiffness / model_->mass.mean();
  state_.drag_force = stiffness * model_->mass.cwiseProduct(before - state_.equilibrium.position);
  if (state_.drag_eases) state_.drag *= kEasedDrag;
  if (state_.drag < kLeastDrag) state_.drag = 0;
}

bool Body::load_slowly(const EquilibriumProblem& whole, EquilibriumState& trial) {
  // A body that sags far under its contents finds its way in parts of the weight.
  if (whole.gravity.isZero()) return false;
  trial = state_.equilibrium;
  for (int part = 1; part <= kWeightParts; ++part) {
    EquilibriumProblem problem = whole;
    problem.gravity *= static_cast<double>(part) / kWeightParts;
    problem.least_motion.from = trial.position;
    EquilibriumProblem again = problem;
    const EquilibriumState before = trial;
    if (solve(problem, trial).converged) continue;
    trial = before;
    if (!relax(again, trial).converged) return false;
  }
  return true;
}

void Body::settle_slack(EquilibriumProblem& problem, EquilibriumState& state) {
  // Held where its mesh is, a slack wall comes to rest a little short of its equilibrium; held there, far less.
  EquilibriumState trial = state;
  problem.least_motion.from = state.position;
  if (solve(problem, trial).converged) {
    state = trial;
  } else {
    newton_->look(problem, state);
  }
}

void Body::solve_statics() {
  EquilibriumProblem problem;
  for (const ChamberModel& chamber : model_->chambers) {
    FluidProblem fluid{.mode = fluid_mode(),
                       .fluid_volume = chamber.rest_volume,
                       .bulk_modulus = model_->definition.fluid.bulk_modulus};
    if (chamber.initial_pressure) {
      fluid.mode = FluidMode::kGivenPressure;
      fluid.pressure = *chamber.initial_pressure;
    }
    problem.fluids.push_back(fluid);
  }
  problem.memory.scale = lasting_part(model_->definition);
  problem.gravity = options_.gravity;
  problem.load_factors = state_.load_factors;
  problem.hold_rigid_motions = model_->rigid_motions.cols() > 0;
  problem.least_motion = least_motion();
  const EquilibriumProblem whole = problem;
  EquilibriumState trial = state_.equilibrium;
  bool is_found = solve(problem, trial).converged;
  for (const bool is_eager : {true, false}) {
    if (is_found || bursts_) break;
    problem = whole;
    trial = state_.equilibrium;
    is_found = relax(problem, trial, {}, is_eager).converged;
  }
  if (!is_found && (bursts_ || !load_slowly(whole, trial))) throw SimulationFailure(describe_failure());
  EquilibriumProblem held = whole;
  if (held.seeks_least_motion()) settle_slack(held, trial);
  // Of what rests as it is given nothing has told yet whether it is stable.
  const bool is_unknown = report_.newton_iterations == 0 && newton_->terms().elastic > 0;
  if (!is_convex_ || is_unknown) buckle(held, trial);
  turn_to_rest(held, trial);
  state_.equilibrium = trial;
}

std::string Body::describe_failure() const {
  std::ostringstream message;
  message << "body `" << model_->definition.name << "`, equilibrium before time zero";
  const char* joint = " under ";
  for (const ChamberModel& chamber : model_->chambers) {
    if (!chamber.initial_pressure) continue;
    message << joint << *chamber.initial_pressure << " Pa";
    joint = " and ";
  }
  const bool has_weight = !options_.gravity.isZero();
  if (has_weight) message << joint << "its weight";
  message << ": " << failure_ << "; a wall holds only so much: take a lower pressure, ";
  if (has_weight) message << "lighter contents (`density`), or hold more of the body (`fixed`), ";
  message << "or a thicker or stiffer wall";
  return message.str();
}

void Body::give_up() const {
  const bool is_held_all_over = std::ranges::all_of(model_->fixed, [](char fixed) { return fixed != 0; });
  const double grown = model_->has_fluid() ? state_.volume.sum() / model_->rest_volume : 1;
  std::ostringstream message;
  message << "body `" << model_->definition.name << "`: " << failure_ << ", also with the step divided "
          << report_.halvings << " times";
  if (is_spent()) message << ", in " << report_.newton_iterations << " iterations in all";
  if (is_held_all_over) {
    message << "; `fixed` holds all of it, so that nothing gives way to a tool";
    if (model_->has_fluid()) message << ", or to fluid that is filled in or taken out and that nothing compresses";
  }
  if (grown > kBlownUpVolume) {
    message << "; it has grown to " << std::fixed << std::setprecision(1) << grown
            << " times its volume, and a wall holds only so much pressure";
  }
  throw SimulationFailure(message.str());
}

void Body::settle(std::vector<double> load_factors) {
  state_.load_factors = std::move(load_factors);
  solve_statics();
  const auto chambers = static_cast<Eigen::Index>(model_->chambers.size());
  state_.volume = enclosed_volumes(*model_, state_.equilibrium.position);
  state_.fluid_volume = state_.volume;
  state_.reference_pressure = Eigen::VectorXd::Zero(chambers);
  for (Eigen::Index c = 0; c < chambers; ++c) {
    const ChamberModel& chamber = model_->chambers[c];
    if (!chamber.initial_pressure) state_.fluid_volume[c] = chamber.rest_volume;
    state_.reference_pressure[c] = chamber.initial_pressure.value_or(0);
  }
  start_leaks(*model_, state_);
  state_.wall = rested_history(*model_, state_.equilibrium.position);
  state_.fluid_motion = fluid_at_rest(*model_, state_);
  report_.unstable = is_unstable_;
  state_.previous_position = state_.equilibrium.position;
  const EquilibriumTerms& terms = newton_->terms();
  state_.static_force = terms.gradient - terms.load_of_pressure() * state_.equilibrium.pressure;
  // What holds a free body until time zero is no load: its fall begins from rest.
  state_.static_force -= newton_->rigid_force(state_.equilibrium);
  state_.load_force = terms.load_force;
  book_stored(0);
  state_.books.script_work = state_.books.stored();
}

}  // namespace thinwall
