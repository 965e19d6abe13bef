#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/equilibrium/Newton.hpp"

namespace thinwall {
namespace {

/// Stiffness of a motion, in units of the wall's, below which it is neutral: round-off leaves flat walls without
/// tension some 1e-14 of either sign, and a thin shell that buckles as a whole has -1e-8.
constexpr double kNeutral = 1e-11;

/// Turns of inverse iteration, which brings the softest motion out by the ratio of the two softest stiffnesses a turn.
constexpr int kInverseTurns = 30;

/// The first part of an edge by which the softest motion is tried, and how often that is doubled.
constexpr double kFirstPart = 1e-3;
constexpr int kDoublings = 14;

/// Turns in which a trial is brought back to the volumes that the contents fill. A straight way misses them to second
/// order, as the energy falls, and at the price that the merit puts on what is missed nothing would seem to fall
/// (Maratos' effect: Nocedal and Wright 2006, section 15.4).
constexpr int kTurnsBack = 2;

/// Part of the energy by which it has to fall to have fallen.
constexpr double kRoundOff = 1e-13;

}  // namespace

bool Newton::is_stable(const EquilibriumProblem& problem, const EquilibriumState& state) {
  evaluate_at_end(problem, state);
  stepped_to_.resize(0);
  double shift = kNeutral;
  return factorize(problem, state, nullptr, shift, true) && is_convex_;
}

Newton::Step Newton::softest_motion(const EquilibriumProblem& problem) {
  Step step;
  step.position.resize(terms_.gradient.size());
  // All motions are in a vector of fractions of multiples of the golden ratio.
  constexpr double kGoldenRatio = 0.618033988749895;
  for (Eigen::Index k = 0; k < step.position.size(); ++k) {
    const double multiple = kGoldenRatio * static_cast<double>(k);
    step.position[k] = multiple - std::floor(multiple) - 0.5;
  }
  for (int turn = 0; turn < kInverseTurns; ++turn) {
    clear_fixed(step.position);
    step.position /= step.position.lpNorm<Eigen::Infinity>();
    Eigen::VectorXd multipliers = missed_constraints(problem, nullptr);
    bordered_.solve(used_factor(), step.position, multipliers);
  }
  step.position *= model_.edge_length / step.position.lpNorm<Eigen::Infinity>();
  step.pressure.setZero(static_cast<Eigen::Index>(problem.fluids.size()));
  step.rigid.setZero(problem.hold_rigid_motions ? rigid_columns_.cols() : 0);
  for (const Attachment& attachment : problem.attachments) step.forces.push_back(attachment.force);
  for (const ContactPoint& contact : terms_.contacts) step.contact_forces.push_back(contact_force(problem, contact));
  return step;
}

void Newton::place_within(const Start& start, Step step, double part, EquilibriumProblem& problem,
                          EquilibriumState& state) {
  step.position *= part;
  place(start, step, 1, problem, state);
  const Eigen::VectorXd no_force = Eigen::VectorXd::Zero(step.position.size());
  for (int turn = 0; turn < kTurnsBack && !bordering_.empty() && std::isfinite(trial_terms_.elastic); ++turn) {
    compute_residual(problem, state, trial_terms_, trial_residual_);
    Step back;
    solve_linear(problem, no_force, &trial_residual_, back);
    step.position += back.position;
    step.pressure += back.pressure;
    place(start, step, 1, problem, state);
  }
}

double Newton::lowest_part(const Step& step, double sign, EquilibriumProblem& problem, EquilibriumState& state,
                           double& lowest) {
  Weights weights{.pressure = 2 * state.pressure.lpNorm<Eigen::Infinity>(), .force = 0, .contact = 0};
  for (const Eigen::Vector3d& force : step.forces) weights.force = std::max(weights.force, 2 * force.norm());
  for (const double force : step.contact_forces) weights.contact = std::max(weights.contact, 2 * force);
  const Start start = kept_start(problem, state);
  const double highest = lowest;
  double best = 0, part = sign * kFirstPart;
  for (int doubling = 0; doubling < kDoublings; ++doubling, part *= 2) {
    if (safe_fraction(start.state.position, part * step.position) < 1) break;
    place_within(start, step, part, problem, state);
    if (!std::isfinite(trial_terms_.elastic)) break;
    if (safe_fraction(start.state.position, state.position - start.state.position) < 1) break;
    compute_residual(problem, state, trial_terms_, trial_residual_);
    const double value = merit(problem, state, trial_terms_, trial_residual_, weights);
    // A small part may fall by less than round-off.
    if (value > highest + kRoundOff * std::abs(highest)) break;
    if (value >= lowest - kRoundOff * std::abs(highest)) continue;
    lowest = value;
    best = part;
  }
  place(start, step, 0, problem, state);
  return best;
}

bool Newton::leave_saddle(EquilibriumProblem& problem, EquilibriumState& state) {
  evaluate_at_end(problem, state);
  stepped_to_.resize(0);
  double shift = kNeutral;
  if (!factorize(problem, state, nullptr, shift, false)) return false;
  const Step step = softest_motion(problem);
  freeze(problem, state);
  compute_residual(problem, state, terms_, trial_residual_);
  double lowest = merit(problem, state, terms_, trial_residual_, {});
  double part = lowest_part(step, 1, problem, state, lowest);
  if (const double other = lowest_part(step, -1, problem, state, lowest); other != 0) part = other;
  if (part == 0) return false;
  const Start start = kept_start(problem, state);
  place_within(start, step, part, problem, state);
  return true;
}

}  // namespace thinwall
