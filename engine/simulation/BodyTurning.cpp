#include <cmath>
#include <memory>
#include <string>

#include "engine/equilibrium/RigidMotions.hpp"
#include "engine/simulation/Body.hpp"

namespace thinwall {
namespace {

/// Part of the largest force above which what holds rigid motions is more than round-off.
constexpr double kHeldForce = 1e-7;

/// Springs, in units of the wall's stiffness, that slow a body down on its way to rest, how they change, and beyond
/// what it does not get there. The part of its stiffness by which a slack wall is held takes their place, and
/// is as strong in all.
constexpr double kFirstSprings = 0.1;
constexpr double kWeakened = 0.25;
constexpr double kStiffened = 8;
constexpr double kStiffestSlowing = 1e3;
constexpr int kEasyTurn = 12;
constexpr int kMostTurns = 1000;
constexpr int kMostIterations = 60;  // of a turn

/// Attitudes that are tried: to hold one keeps the mean rotation of small motions, so that it may be off by some.
constexpr int kMostAttitudes = 4;

/// Whether forces push a part of the wall along an axis on which nothing holds it: it then comes to rest nowhere.
bool drives_off(const BodyModel& model, const Eigen::VectorXd& force) {
  const std::vector<int> part_of = wall_parts(model);
  Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, model.vertices()), held = sum;
  for (int v = 0; v < model.vertices(); ++v) {
    sum.col(part_of[v]) += force.segment<3>(3 * v);
    for (int axis = 0; axis < 3; ++axis) held(axis, part_of[v]) += model.fixed[3 * v + axis] != 0;
  }
  const double scale = force.cwiseAbs().sum();
  return ((held.array() == 0) && (sum.array().abs() > kHeldForce * scale)).any();
}

EquilibriumProblem slowed_down(const BodyModel& model, const EquilibriumProblem& problem, double springs,
                               const Eigen::VectorXd& position) {
  EquilibriumProblem slowed = problem;
  slowed.hold_rigid_motions = false;
  if (problem.seeks_least_motion()) {
    slowed.least_motion = {.part = springs, .from = position};
    return slowed;
  }
  slowed.inertia = springs * model.wall_stiffness / model.mass.mean();
  slowed.inertia_target = position;
  return slowed;
}

}  // namespace

bool Body::is_turned_by_loads(const EquilibriumProblem& problem, const EquilibriumState& state) const {
  const EquilibriumTerms& terms = newton_->terms();
  const bool has_loads = !problem.gravity.isZero() || !model_->loads.empty();
  if (snaps_ || stays_held_ || !problem.hold_rigid_motions || !has_loads) return false;
  // What a tool pushes, and nothing else holds, would follow it for ever; and what a cut has let go stays where it is,
  // as in an analysis without inertia its fall is no motion that the books could tell of.
  if (!problem.attachments.empty() || !problem.shafts.empty() || !terms.contacts.empty()) return false;
  if (state_.cut.has_incised || state_.cut.tool) return false;
  const Eigen::VectorXd force = newton_->rigid_force(state);
  return force.lpNorm<Eigen::Infinity>() > kHeldForce * terms.largest_force && !drives_off(*model_, force);
}

bool Body::turn(const EquilibriumProblem& problem, EquilibriumState& state) {
  double springs = kFirstSprings;
  for (int k = 0; k < kMostTurns && springs < kStiffestSlowing; ++k) {
    EquilibriumState trial = state;
    EquilibriumProblem slowed = slowed_down(*model_, problem, springs, state.position);
    const NewtonResult result = solve(slowed, trial, {.most_iterations = kMostIterations, .takes_flaps = true});
    if (!result.converged) {
      springs *= kStiffened;
      continue;
    }
    const Eigen::VectorXd way = trial.position - state.position;
    state = trial;
    const Eigen::VectorXd slowing = springs * model_->wall_stiffness / model_->mass.mean() * model_->mass;
    const double held = slowing.cwiseProduct(way).lpNorm<Eigen::Infinity>();
    if (held < 0.1 * kHeldForce * result.force_scale) return true;
    if (result.iterations <= kEasyTurn) springs *= kWeakened;
  }
  return false;
}

bool Body::find_turned(EquilibriumProblem& problem, EquilibriumState& state) {
  EquilibriumState trial = state;
  if (!turn(problem, trial)) {
    // Where it does not get there at first it does not in the steps to come, each of which would take as long.
    stays_held_ = true;
    return false;
  }
  auto turned = std::make_unique<BodyModel>(*model_);
  hold_rigid_motions(*turned, trial.position);
  std::unique_ptr<const BodyModel> model = std::move(turned);
  auto newton = std::make_unique<Newton>(*model, *newton_, trial.position);
  std::swap(newton, newton_);
  std::swap(model, model_);
  EquilibriumProblem again = problem;
  again.least_motion.from = trial.position;
  trial.rigid_reaction.resize(0);
  if (!solve(again, trial, {.takes_flaps = true}).converged) {
    // As many motions may not be held in the other attitude as in the one where the body stays.
    std::swap(newton, newton_);
    std::swap(model, model_);
    return false;
  }
  problem = again;
  state = trial;
  return true;
}

void Body::turn_to_rest(EquilibriumProblem& problem, EquilibriumState& state) {
  for (int k = 0; k < kMostAttitudes && is_turned_by_loads(problem, state); ++k) {
    const std::string failure = failure_;
    const bool was_loose = is_loose_;
    const double residual = report_.residual;
    if (find_turned(problem, state)) continue;
    // What was found before stays, and with it what is known of it.
    failure_ = failure;
    is_loose_ = was_loose;
    report_.residual = residual;
    newton_->look(problem, state);
    return;
  }
}

}  // namespace thinwall
