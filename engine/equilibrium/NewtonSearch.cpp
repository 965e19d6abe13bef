#include "engine/equilibrium/Newton.hpp"

#include <algorithm>
#include <cmath>

#include "engine/equilibrium/OpenChambers.hpp"

namespace thinwall {
namespace {

/// How often the root of the wall's area a step moves a vertex at most: a slack wall asks for steps without
/// bound, along whose ways everything would meet everything.
constexpr double kLongestStep = 1;

/// Part of the foreseen fall of the energy that has to come about for the curvature to be trusted: some three quarters,
/// as where steps are bounded by a region of trust (Nocedal and Wright 2006, algorithm 4.1).
constexpr double kForeseenPart = 0.8;

/// Part of the energy below which its slope along a step has no sign.
constexpr double kRoundOff = 1e-12;

double square(double value) {
  return value * value;
}

}  // namespace

void Newton::freeze(const EquilibriumProblem& problem, const EquilibriumState& state) {
  frozen_.position = state.position;
  frozen_.lip_force = terms_.lip_force;
  frozen_.pressure = state.pressure;
  frozen_.outflow.setZero(state.pressure.size());
  frozen_.lip_spill.setZero(model_.has_open_chambers() ? state.position.size() : 0);
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    if (problem.fluids[c].vent >= 0) continue;
    frozen_.pressure[c] = 0;
    if (!model_.is_open(c) || !problem.fluids[c].is_multiplier()) continue;
    const OpeningEquation equation = opening_equation(model_, problem, terms_, c, state.position, state.pressure, true);
    frozen_.outflow[c] = equation.by_pressure;
    frozen_.lip_spill += state.pressure[c] * equation.by_position;
  }
}

double Newton::merit(const EquilibriumProblem& problem, const EquilibriumState& state, const EquilibriumTerms& terms,
                     const Residual& residual, const Weights& weights) const {
  double value = terms.elastic + terms.bending + terms.folds.energy + terms.gravity - terms.load_work + terms.inertial +
                 terms.friction + weights.pressure * residual.volume.lpNorm<1>();
  for (std::size_t c = 0; c < problem.fluids.size(); ++c) {
    const FluidProblem& fluid = problem.fluids[c];
    if (fluid.mode == FluidMode::kGivenPressure) value -= fluid.pressure * terms.volume[c];
    if (fluid.vent >= 0) {
      value -= frozen_.pressure[c] * terms.volume[c];
      continue;
    }
    value += 0.5 * (fluid.compliance(state.pressure[c]) + frozen_.outflow[c]) * square(state.pressure[c]);
  }
  if (model_.has_open_chambers()) {
    value += (frozen_.lip_force + frozen_.lip_spill).dot(state.position - frozen_.position);
  }
  for (const Eigen::Vector3d& gap : residual.gaps) value += weights.force * gap.norm();
  // A contact is a spring of compliance 1 / stiffness beside a constraint that gives way by it: what violates it is the
  // part of the overlap that its force does not account for.
  for (const ContactPoint& contact : terms.contacts) {
    const double force = contact_force(problem, contact), stiffness = contact.potential.stiffness;
    value += 0.5 * square(force) / stiffness;
    value += weights.contact * std::max(0.0, (contact_law(contact) - force) / stiffness);
  }
  return value;
}

double Newton::merit_slope(const EquilibriumProblem& problem, const EquilibriumState& state, const Residual& residual,
                           const Step& step, const Weights& weights) const {
  Eigen::VectorXd smooth = residual.force;
  if (problem.hold_rigid_motions) smooth -= rigid_columns_ * state.rigid_reaction;
  double slope = -weights.pressure * residual.volume.lpNorm<1>();
  for (std::size_t c = 0; c < problem.fluids.size(); ++c) {
    if (problem.fluids[c].seeks_volume()) smooth += state.pressure[c] * terms_.volume_gradient.col(c);
    if (problem.fluids[c].vent >= 0) continue;
    const double compliance = problem.fluids[c].compliance(state.pressure[c]) + frozen_.outflow[c];
    slope += compliance * state.pressure[c] * step.pressure[c];
    if (problem.fluids[c].has_surface) slope += terms_.filled_by_pressure[c] * state.pressure[c] * step.pressure[c];
  }
  if (model_.has_open_chambers()) smooth += frozen_.lip_spill;
  slope += smooth.dot(step.position);
  for (std::size_t k = 0; k < residual.gaps.size(); ++k) {
    slope -= problem.attachments[k].force.dot(material_point(problem.attachments[k], step.position)) +
             weights.force * residual.gaps[k].norm();
  }
  for (std::size_t k = 0; k < terms_.contacts.size(); ++k) {
    const ContactPoint& contact = terms_.contacts[k];
    const double force = contact_force(problem, contact), stiffness = contact.potential.stiffness;
    slope += force * (gap_change(contact, step.position) + (step.contact_forces[k] - force) / stiffness) -
             weights.contact * std::max(0.0, (contact_law(contact) - force) / stiffness);
  }
  return slope;
}

Newton::Descent Newton::search(EquilibriumProblem& problem, EquilibriumState& state, Residual& residual,
                               const Step& step, double fraction) {
  // Weights above the multipliers make the merit function exact: its minimum is the constrained one.
  Weights weights{.pressure = 2 * (state.pressure + step.pressure).lpNorm<Eigen::Infinity>(), .force = 0, .contact = 0};
  for (const Eigen::Vector3d& force : step.forces) weights.force = std::max(weights.force, 2 * force.norm());
  for (const double force : step.contact_forces) weights.contact = std::max(weights.contact, 2 * force);
  freeze(problem, state);
  const double before = merit(problem, state, terms_, residual, weights);
  const double slope = merit_slope(problem, state, residual, step, weights);
  if (slope > kRoundOff * std::abs(before)) ++ascending_steps_;
  const Start& start = kept_start(problem, state);
  Residual& trial = trial_residual_;
  const double longest = kLongestStep * std::sqrt(model_.rest_area);
  fraction = std::min(fraction, longest / std::max(longest, step.position.lpNorm<Eigen::Infinity>()));
  fraction *= safe_fraction(start.state.position, fraction * step.position);
  for (int halving = 0; halving < 16; ++halving, fraction *= 0.5) {
    place(start, step, fraction, problem, state);
    if (!std::isfinite(trial_terms_.elastic)) continue;
    compute_residual(problem, state, trial_terms_, trial);
    const bool residual_fell = trial.measure <= (1 - 0.1 * fraction) * residual.measure;
    const double reached = merit(problem, state, trial_terms_, trial, weights);
    const bool merit_fell = reached <= before + 1e-4 * fraction * slope;
    if (residual_fell || merit_fell) {
      std::swap(terms_, trial_terms_);
      // Along a step that the whole curvature gave the energy is a parabola whose foot is at its end.
      const double foreseen = fraction * (1 - 0.5 * fraction) * slope;
      const bool tells = halving == 0 && is_exact_ && is_convex_ && slope < 0;
      return tells && reached - before <= kForeseenPart * foreseen ? Descent::kAsForeseen : Descent::kLower;
    }
  }
  go_back(start, problem, state);
  return Descent::kNone;
}

Newton::Start Newton::started(const EquilibriumProblem& problem, const EquilibriumState& state) {
  return {.state = state, .attachments = problem.attachments, .solids = problem.solids, .friction = problem.friction};
}

void Newton::go_back(const Start& start, EquilibriumProblem& problem, EquilibriumState& state) {
  state = start.state;
  problem.attachments = start.attachments;
  problem.solids = start.solids;
  problem.friction = start.friction;
}

const Newton::Start& Newton::kept_start(const EquilibriumProblem& problem, const EquilibriumState& state) {
  start_.state = state;
  start_.attachments = problem.attachments;
  start_.solids = problem.solids;
  start_.friction = problem.friction;
  return start_;
}

void Newton::place(const Start& start, const Step& step, double fraction, EquilibriumProblem& problem,
                   EquilibriumState& state) {
  state.position = start.state.position + fraction * step.position;
  state.pressure = start.state.pressure + fraction * step.pressure;
  if (step.rigid.size() > 0) state.rigid_reaction = start.state.rigid_reaction + fraction * step.rigid;
  for (std::size_t k = 0; k < start.attachments.size(); ++k) {
    const Eigen::Vector3d& old = start.attachments[k].force;
    problem.attachments[k].force = old + fraction * (step.forces[k] - old);
  }
  for (std::size_t k = 0; k < terms_.contacts.size(); ++k) {
    const ContactPoint& contact = terms_.contacts[k];
    const double old = start.solids[contact.solid].forces[contact.site];
    problem.solids[contact.solid].forces[contact.site] = old + fraction * (step.contact_forces[k] - old);
  }
  problem.friction = start.friction;
  advance_estimates(model_, start.state.position, step.position, fraction, problem.friction);
  evaluate_all(problem, state, !may_end_, trial_terms_);
}

bool Newton::take_whole(EquilibriumProblem& problem, EquilibriumState& state, Residual& residual, const Step& step) {
  // A step that is longer than the body has gone astray, and so has what is not a number.
  if (!(step.position.lpNorm<Eigen::Infinity>() <= extent_)) return false;
  const Start& start = kept_start(problem, state);
  const double fraction = std::min(1.0, safe_fraction(state.position, step.position));
  foresee(problem, state.position, fraction * step.position);
  place(start, step, fraction, problem, state);
  if (!std::isfinite(trial_terms_.elastic) || !std::isfinite(trial_terms_.bending)) return false;
  compute_residual(problem, state, trial_terms_, residual);
  std::swap(terms_, trial_terms_);
  return true;
}

}  // namespace thinwall
