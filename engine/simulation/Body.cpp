#include "engine/simulation/Body.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "engine/equilibrium/HeldWall.hpp"
#include "engine/equilibrium/LeastMotion.hpp"
#include "engine/simulation/Leakage.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "engine/simulation/StepAccuracy.hpp"
#include "engine/simulation/ToolFriction.hpp"
#include "engine/tool/PoseBetween.hpp"

namespace thinwall {
namespace {

/// Halvings of a quasi-static step after which the body is relaxed towards its equilibrium.
constexpr int kHalvingsBeforeRelaxing = 2;

/// Halvings of a dynamic step of a cut body after which it creeps.
constexpr int kHalvingsBeforeCreeping = 4;

/// Halvings of a step after which a wall that a blade presses, and has not cut yet, may crumple.
constexpr int kHalvingsBeforeCrumpling = 4;

/// Halvings of a step after which edges that came past the rims of a flat tool may stay in it: a coarse wall crushed
/// between the tool and itself may have no room for them.
constexpr int kHalvingsBeforeLettingEdgesIn = 2;

std::vector<ToolPose> interpolate(std::span<const ToolPose> begin, std::span<const ToolPose> end, double fraction) {
  std::vector<ToolPose> poses(begin.begin(), begin.end());
  for (std::size_t k = 0; k < poses.size(); ++k) poses[k] = between(begin[k], end[k], fraction);
  return poses;
}

/// Mean edge lengths that a blade goes at most in a part of a step: what its lips let go is booked by the mean of the
/// forces at both ends.
constexpr double kBladeEdges = 0.5;

/// Halvings in one step after which a body makes no way any more.
constexpr int kMostHalvings = 60;

/// Parts of a step that may burst: a jump that went too far is cured by a division or two, and where the wall bears no
/// more each part ends so, however short, after more than a thousand iterations.
constexpr int kMostBursts = 2;

/// Iterations up to which the next part may be longer.
constexpr int kEasyIterations = 20;

/// Smallest part into which a step is divided to keep its error: where a tool hits the wall no step is small enough.
constexpr double kSmallestPart = 1.0 / 256;

/// The smallest part of a step that is divided because needles would work more than they may.
constexpr double kSmallestNeedlePart = 1.0 / 1024;

/// The parts into which a step is divided, one after the other.
struct StepParts {
  double largest = 1;   // that tools and blades allow
  double done = 0;      // of the step
  double part = 1;      // of the step, that is tried
  double division = 1;  // the same of the largest, but for what the end of the step takes off

  void divide() {
    part *= 0.5;
    division *= 0.5;
  }
  void go_on(bool may_double) {
    done += part;
    if (may_double) {
      part *= 2;
      division = std::min(1.0, 2 * division);
    }
    part = std::min(part, largest);
    // No part is left that only round-off makes.
    if (done + part > 1 - 1e-6 * largest) part = 1 - done;
  }
};

/// The part of the step in which a blade goes over few edges.
double part_of_blade(const BodyInput& input, double edge_length) {
  const bool moves = input.blade && input.blade->travel > 0;
  return moves ? 1 / std::ceil(input.blade->travel / (kBladeEdges * edge_length)) : 1;
}

/// The share of a part of the step from `done` on.
BodyInput part_of(const BodyInput& input, const BodyState& start, double done, double part) {
  BodyInput share = input;
  for (std::size_t k = 0; k < share.load_factors.size(); ++k) {
    const double begin = k < start.load_factors.size() ? start.load_factors[k] : 1;
    share.load_factors[k] = begin + (done + part) * (input.load_factors[k] - begin);
  }
  // In a gap of the wall a blade has nothing to cut.
  if (!start.cut.is_in_wall() && start.cut.ahead == 0) share.blade.reset();
  if (share.blade) share.blade->travel *= part;
  for (std::size_t k = 0; k < share.fluids.size(); ++k) {
    share.fluids[k].added *= part;
    if (!share.fluids[k].pressure) continue;
    const double begin = start.equilibrium.pressure[k];
    share.fluids[k].pressure = begin + (done + part) * (*input.fluids[k].pressure - begin);
  }
  return share;
}

/// In statics a slack wall is held by its least motion instead of a stiffness, which would press across wrinkles.
double slack_stiffness(Analysis analysis) {
  return analysis == Analysis::kQuasiStatic ? 0 : kSlackStiffness;
}

}  // namespace

Body::Body(BodyDefinition definition, std::vector<ToolDefinition> tools, SimulationOptions options)
    : model_(
          std::make_unique<const BodyModel>(make_body_model(std::move(definition), slack_stiffness(options.analysis)))),
      tools_(std::move(tools)),
      options_(std::move(options)),
      newton_(std::make_unique<Newton>(*model_)) {
  const Eigen::Index unknowns = model_->rest_position.size();
  state_.equilibrium.position = model_->rest_position;
  state_.velocity = state_.acceleration = state_.previous_velocity = state_.static_force = state_.load_force =
      Eigen::VectorXd::Zero(unknowns);
  state_.previous_position = model_->rest_position;
  state_.contacts.resize(tools_.size());
  for (int tool = 0; tool < static_cast<int>(tools_.size()); ++tool) {
    solids_.insert(solids_.end(), contact_solids(tools_[tool], {}).size(), tool);
  }
  const std::size_t solids = solids_.size();
  state_.solid_contacts.resize(solids);
  state_.solid_forces.assign(solids, std::vector<double>(model_->sites.size(), 0));
  state_.friction.resize(solids);
  state_.pressing.resize(tools_.size());
}

FluidMode Body::fluid_mode() const {
  return model_->definition.fluid.kind == FluidKind::kCompressible ? FluidMode::kCompressible
                                                                   : FluidMode::kIncompressible;
}

bool Body::may_snap() const {
  return snaps_ || (options_.analysis == Analysis::kQuasiStatic && report_.halvings >= kHalvingsBeforeRelaxing);
}

bool Body::is_left_slack() const {
  const bool is_quasi_static = options_.analysis == Analysis::kQuasiStatic;
  const bool is_stuck = state_.drag > 0 || report_.halvings >= kHalvingsBeforeCreeping;
  if (state_.cut.has_incised || state_.cut.has_crumpled) return is_quasi_static || is_stuck;
  // A blade crumples a membrane that is not held behind it before it has cut it at all.
  const bool is_membrane = model_->definition.model == WallModel::kMembrane;
  return is_quasi_static && is_membrane && (surface_ || state_.cut.tool);
}

bool Body::may_creep() const {
  return !snaps_ && is_left_slack();
}

bool Body::leaves_rest_to_steps() const {
  return snaps_ && (options_.analysis == Analysis::kDynamic || is_left_slack());
}

bool Body::may_crumple() const {
  // A blade that comes from beside a membrane presses it along itself. Without bending stiffness the wall then has
  // equilibria as fine as its mesh, and none that a solver finds.
  const BodyDefinition& definition = model_->definition;
  const bool has_blade =
      std::ranges::any_of(tools_, [](const ToolDefinition& tool) { return tool.kind == ToolKind::kScalpel; });
  return has_blade && !definition.toughness.empty() && definition.model == WallModel::kMembrane &&
         !definition.tension_field && report_.halvings >= kHalvingsBeforeCrumpling && !is_held_in_its_plane(*model_);
}

LeastMotion Body::least_motion() const {
  const bool is_slack = model_->definition.tension_field && options_.analysis == Analysis::kQuasiStatic;
  return {.part = is_slack ? kLeastMotion : 0, .from = state_.equilibrium.position};
}

EquilibriumProblem Body::make_problem(std::span<const ToolPose> end, double duration, const BodyInput& input) const {
  EquilibriumProblem problem;
  add_fluids(duration, input, problem);
  Leakage(*model_, state_, options_.gravity, duration).add_to(problem);
  problem.memory = memory_after(*model_, state_.wall,
                                {.duration = duration, .previous = state_.previous_step, .is_damped = !snaps_});
  problem.gravity = options_.gravity;
  problem.load_factors = input.load_factors;
  problem.start = state_.equilibrium.position;
  problem.least_motion = least_motion();
  problem.cut_force = force_at_lips(let_go(state_.cut, input.blade), model_->unknowns());
  step_contacts().add_solids(end, problem);
  step_contacts().add_shafts(end, problem);
  problem.hold_rigid_motions = !has_inertia() && model_->rigid_motions.cols() > 0;
  return problem;
}

bool Body::try_step(std::span<const ToolPose> begin, std::span<const ToolPose> end, double duration,
                    const BodyInput& input) {
  EquilibriumProblem problem = make_problem(end, duration, input);
  step_contacts().attach(begin, end, problem);
  step_contacts().refuse_held_places(problem);
  problem.friction = FrictionSearch(*model_, state_, tools_, begin).first(problem);
  EquilibriumState trial;
  for (;;) {
    // What a tool takes hold of or lets go of changes its velocity at once; a difference that reaches back across that
    // would see the jump as a motion.
    if (problem.attachments.size() != state_.attachments.size()) state_.previous_step = 0;
    if (has_inertia()) add_inertia(duration, problem);
    trial = state_.equilibrium;
    if (has_inertia()) begin_as_moving(duration, problem, trial);
    const bool goes_on = last_step_ && begin_as_extrapolated(begin, end, problem, trial);
    if (foresight_ && !goes_on) begin_as_foreseen(begin, end, problem, trial);
    if (!solve_with_leaks(problem, trial, begin, duration)) return false;
    if (may_buckle(problem)) {
      buckle(problem, trial);
    } else {
      is_unstable_ = false;
    }
    turn_to_rest(problem, trial);
    if (!may_snap() && jumped_over_tools(*model_, step_contacts().way(begin, problem), problem, trial.position)) {
      failure_ =
          "the wall jumped over a ball, a rod, a plate or a needle's point, as where it is pressed against what is "
          "held; press it less deep";
      return false;
    }
    if (step_contacts().release(end, problem)) continue;
    const bool lets_edges_in = report_.halvings >= kHalvingsBeforeLettingEdgesIn;
    if (!lets_edges_in && step_contacts().catch_passed_edges(problem, trial.position)) continue;
    if (options_.extrapolates) note_last_step(begin, end);
    accept(begin, duration, problem, input, trial);
    return true;
  }
}

bool Body::takes_back_driven(BodyState& before) {
  if (!mark_driving(state_.cut, before.cut)) return false;
  // Again without what drove the wall: a cut that opens by itself is free, and its energy a motion.
  state_ = std::move(before);
  last_step_.reset();
  ++report_.refinements;
  return true;
}

void Body::advance(std::span<const ToolPose> begin, std::span<const ToolPose> end, double duration,
                   const BodyInput& input) {
  report_ = {};
  state_.cut.run = 0;
  note_passing(input.needles, begin, state_.piercing);
  note_passing(input.blades, begin, state_.incising);
  const BodyState start = state_;
  try {
    advance_in_parts(start, begin, end, duration, input);
  } catch (const SimulationFailure&) {
    // What has given way cannot be mended.
    if (report_.ruptures.empty()) {
      state_ = start;
      last_step_.reset();
    }
    throw;
  }
  state_.cut.division = 1;
  tell_ruptures_within_step();
  foresight_.reset();
}

bool Body::is_hopeless(int failed) const {
  return failed > options_.maximum_halvings || report_.halvings > kMostHalvings || report_.bursts > kMostBursts ||
         report_.is_past_bearing || is_spent();
}

void Body::advance_in_parts(const BodyState& start, std::span<const ToolPose> begin, std::span<const ToolPose> end,
                            double duration, const BodyInput& input) {
  const double largest = std::min(step_contacts().largest_part(begin, end), part_of_blade(input, model_->edge_length));
  StepParts step{.largest = largest, .part = largest};
  std::vector<ToolPose> from(begin.begin(), begin.end());
  bool needles_ask = false;
  int failed = 0;  // in a row
  while (step.done < 1) {
    const std::vector<ToolPose> to = interpolate(begin, end, step.done + step.part);
    BodyState before = state_;
    state_.cut.division = step.division;
    const int iterations = report_.newton_iterations, shifted = report_.shifted_iterations;
    bursts_ = false;
    if (!try_step(from, to, step.part * duration, part_of(input, start, step.done, step.part))) {
      state_ = before;
      last_step_.reset();
      if (may_crumple()) {
        crumple(from);
        continue;
      }
      step.divide();
      ++report_.halvings;
      if (bursts_) ++report_.bursts;
      if (is_hopeless(++failed)) give_up();
      continue;
    }
    failed = 0;
    if (takes_back_driven(before)) continue;
    const bool was_easy = report_.newton_iterations - iterations <= kEasyIterations;
    // Where flaps flutter the matrix is not convex at first, and shorter steps show more of that.
    const bool is_calm = report_.shifted_iterations == shifted && report_.halvings == 0;
    const StepAccuracy accuracy(*model_, options_, before, state_);
    const double error = accuracy.error(step.part * duration), unbooked = accuracy.unbooked(is_calm);
    const bool is_coarse =
        (error > 1 && step.part > kSmallestPart) || (unbooked > 1 && step.part > accuracy.smallest_part(step.largest));
    const bool overshoots = !is_coarse && step.part > kSmallestNeedlePart && needles_overshoot(before, to);
    if (is_coarse || overshoots) {
      state_ = before;
      step.divide();
      ++report_.refinements;
      needles_ask = needles_ask || overshoots;
      continue;
    }
    go_through_held_wall(from, to);
    if (needles_ask) pierce_within_step(to);
    from = to;
    // Doubled only where the error allows it: it grows with the cube of the step.
    step.go_on(was_easy && std::max(error, unbooked) < 0.1);
  }
}

}  // namespace thinwall
