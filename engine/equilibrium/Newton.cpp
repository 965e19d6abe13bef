#include "engine/equilibrium/Newton.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/equilibrium/OpenChambers.hpp"
#include "engine/mesh/MeshMeasures.hpp"

namespace thinwall {
namespace {

/// Iterations in a row with a matrix that was made convex after which it is taken as it is: a flat wall that is pressed
/// along itself stays flat, and on the way to that equilibrium no matrix is convex.
constexpr int kInexactSteps = 5;

/// Steps of a shell without line search before it is solved with one.
constexpr int kForeseeingSteps = 40;

/// Growth of the largest force in a solution of a shell without line search that only a step gone astray makes: among
/// such forces any residual would look small.
constexpr double kBlowUp = 1e6;

/// A wall pressed upon itself may be so stiff that the round-off of its coordinates alone makes forces above the
/// tolerance, and where it buckles a force may fall without end: so many iterations after it was least, a residual
/// below this multiple of the tolerance is the solution, but never above this part of the largest force.
constexpr int kStalledSteps = 8;
constexpr double kRoundOffResidual = 1e3;
constexpr double kLooseResidual = 1e-2;

/// Part of the mean edge below which a step leaves the curvature as good as it was.
constexpr double kSmallStep = 0.05;

/// What constraints may be missed by where forces are wanted to the last digits: part of a chamber's volume, and of the
/// mean edge. The first grows with the tolerance of the forces, of which it is this part, or that one where a larger
/// residual of the forces is taken as no step gains anything: one that closes the volume alone would not either.
constexpr double kVolumeTolerance = 1e-11;
constexpr double kVolumeShare = 1e-2;
constexpr double kStalledVolumeShare = 1e-1;
constexpr double kGapTolerance = 1e-9;

/// Part of the cube of a body's distance from the origin below which a volume cannot be told: it is a sum of products
/// of three coordinates, each rounded by 1e-16, over all triangles. Wanted closer, a ball of 20 mm at 5 m takes
/// hundreds of iterations a step, with this 5.
constexpr double kFarVolume = 1e-15;

/// Strain whose forces are the least that others are held against, and that of an unstressed wall that the round-off of
/// its coordinates may make.
constexpr double kLittleStrain = 1e-4;
constexpr double kRoundOffStrain = 1e-13;

/// Part of the largest load below which what is left of it is no longer felt. Among loads that light there are no other
/// forces: what they do to a slender wall may be as large as any motion of it.
constexpr double kUnfeltLoad = 1e-3;

double square(double value) {
  return value * value;
}

/// The first of them as it is in a model. A thin shell bends under much less than what strains it so.
double little_strain(const BodyModel& model) {
  if (model.bending.empty()) return kLittleStrain;
  double volume = 0;
  for (const MembraneRest& rest : model.rest) volume += rest.area * rest.thickness;
  return kLittleStrain * std::min(1.0, square(volume / (model.rest_area * model.edge_length)));
}

/// Newton, of a residual with which nothing has to move: less than forces of round-off, and of any load no more than a
/// little part is left. What holds the lips of a cut is no load: it is let go until nothing is left of it.
double unfelt_force(const EquilibriumProblem& problem, const EquilibriumTerms& terms, double force_scale,
                    double tolerance) {
  const double exact = kRoundOffStrain / kLittleStrain * force_scale;
  const double unfelt = std::max(tolerance * terms.largest_force, exact);
  const double load = problem.cut_force.size() == 0 ? terms.load_force.lpNorm<Eigen::Infinity>()
                                                    : (terms.load_force - problem.cut_force).lpNorm<Eigen::Infinity>();
  return load > 0 ? std::min(unfelt, kUnfeltLoad * load) : unfelt;
}

NewtonResult solved(bool is_loose, NewtonResult result) {
  result.converged = true;
  result.is_loose = is_loose;
  return result;
}

NewtonResult failed(std::string reason, NewtonResult result) {
  result.converged = false;
  result.reason = std::move(reason);
  return result;
}

}  // namespace

Newton::Newton(const BodyModel& model)
    : Newton(model, SparseFactor(model.pattern), SelfContact(self_contact_of(model))) {}

Newton::Newton(const BodyModel& model, const Newton& before, const Eigen::VectorXd& position)
    : Newton(model, carried_parts(model, before, position)) {
  doubles_left_ = before.doubles_left_;
}

Newton::Newton(const BodyModel& model, CarriedParts parts)
    : Newton(model, *std::move(parts.factor), *std::move(parts.self_contact)) {}

Newton::CarriedParts Newton::carried_parts(const BodyModel& model, const Newton& before,
                                           const Eigen::VectorXd& position) {
  CarriedParts parts;
  tbb::parallel_invoke([&] { parts.factor.emplace(model.pattern, before.factor_); },
                       [&] {
                         const SelfContact& old = before.self_contact_;
                         parts.self_contact.emplace(self_contact_of(model, position, old.edge_length()), old);
                       });
  return parts;
}

Newton::Newton(const BodyModel& model, SparseFactor factor, SelfContact self_contact)
    : model_(model),
      factor_(std::move(factor)),
      self_contact_(std::move(self_contact)),
      fold_matrix_(model),
      rims_(rim_unknowns(model)),
      rigid_columns_(model.rigid_motions),
      extent_(bounding_box(model.definition.mesh.vertices).diagonal().norm()),
      little_strain_(little_strain(model)) {
  const double mean_mass = model.mass.mean();
  for (Eigen::Index k = 0; k < rigid_columns_.rows(); ++k) rigid_columns_.row(k) *= model.mass[k] / mean_mass;
  hinges_ = hinges_of(model);
}

void Newton::evaluate_all(const EquilibriumProblem& problem, const EquilibriumState& state, bool with_hessian,
                          EquilibriumTerms& terms) {
  evaluate(model_, problem, state.position, state.pressure, with_hessian, terms,
           [&] { self_contact_.look(state.position); });
  self_contact_.evaluate(state.position, terms.folds, terms.gradient);
  terms.largest_force = std::max(terms.largest_force, terms.folds.largest_force);
}

double Newton::contact_force(const EquilibriumProblem& problem, const ContactPoint& contact) const {
  return problem.solids[contact.solid].forces[contact.site];
}

double Newton::contact_law(const ContactPoint& contact) const {
  return contact.potential.spring_force(contact.gap.gap);
}

void Newton::compute_residual(const EquilibriumProblem& problem, const EquilibriumState& state,
                              const EquilibriumTerms& terms, Residual& residual) const {
  residual.force = terms.gradient;
  if (problem.inertia != 0) {
    residual.force.array() += problem.inertia * model_.mass.array() * (state.position - problem.inertia_target).array();
  }
  if (!problem.fluids.empty()) residual.force -= terms.load_of_pressure() * state.pressure;
  residual.gaps.clear();
  for (const Attachment& attachment : problem.attachments) {
    for (int k = 0; k < 3; ++k) {
      residual.force.segment<3>(3 * attachment.vertices[k]) += attachment.weights[k] * attachment.force;
    }
    residual.gaps.push_back(
        attachment.prescribed.cwiseProduct(material_point(attachment, state.position) - attachment.target));
  }
  residual.contact = residual.ghost = residual.opening = 0;
  residual.rigid.resize(0);
  double misfits = 0;  // metres^2
  for (const ContactPoint& contact : terms.contacts) {
    const double force = contact_force(problem, contact);
    for (int k = 0; k < 3; ++k) {
      residual.force.segment<3>(3 * model_.surface[contact.triangle][k]) -=
          force * contact.gap.gradient.segment<3>(3 * k);
    }
    const double misfit = (force - std::max(0.0, contact_law(contact))) / contact.potential.stiffness;
    residual.contact = std::max(residual.contact, std::abs(misfit));
    misfits += square(misfit);
    if (force <= 0 || contact_law(contact) > 0) continue;
    residual.ghost = std::max(residual.ghost, force);
    residual.opening = std::max(residual.opening, -contact_law(contact) / contact.potential.stiffness);
  }
  if (problem.hold_rigid_motions) {
    residual.force += rigid_columns_ * state.rigid_reaction;
    residual.rigid = rigid_columns_.transpose() * (state.position - model_.held_position);
  }
  compute_volume_residual(problem, state, terms, residual);
  clear_fixed(residual.force);
  residual.largest_force = residual.force.cwiseAbs().maxCoeff();
  for (const Eigen::Vector3d& gap : residual.gaps) misfits += gap.squaredNorm();
  misfits += residual.volume.squaredNorm() / square(model_.rest_area);
  residual.measure = std::sqrt(residual.force.squaredNorm() + square(model_.wall_stiffness) * misfits);
}

void Newton::compute_volume_residual(const EquilibriumProblem& problem, const EquilibriumState& state,
                                     const EquilibriumTerms& terms, Residual& residual) const {
  const Eigen::VectorXd& filled = terms.lips.empty() ? terms.volume : terms.filled;
  residual.volume.setZero(static_cast<Eigen::Index>(problem.fluids.size()));
  for (std::size_t c = 0; c < problem.fluids.size(); ++c) {
    const FluidProblem& fluid = problem.fluids[c];
    if (!fluid.is_multiplier()) continue;
    if (fluid.vent < 0) {
      residual.volume[c] = filled[c] - fluid.space(state.pressure[c]);
    }
    const int chamber = static_cast<int>(c);
    if (!model_.is_open(chamber)) continue;
    residual.volume[c] +=
        opening_equation(model_, problem, terms, chamber, state.position, state.pressure, false).value;
  }
  if (problem.orifice_time == 0) return;
  // What flows is counted by the space that it fills at its reference pressure.
  const auto held = [&](int c) { return problem.fluids[c].held(state.pressure[c]); };
  for (const OrificeDefinition& orifice : model_.definition.fluid.orifices) {
    const double flown = problem.orifice_time * flow_between(model_, orifice, problem.gravity, state.pressure).rate;
    if (problem.fluids[orifice.from].seeks_volume()) residual.volume[orifice.from] += flown * held(orifice.from);
    if (problem.fluids[orifice.to].seeks_volume()) residual.volume[orifice.to] -= flown * held(orifice.to);
  }
}

void Newton::clear_fixed(Eigen::VectorXd& forces) const {
  for (Eigen::Index k = 0; k < forces.size(); ++k) {
    if (model_.fixed[k]) forces[k] = 0;
  }
}

double Newton::force_scale(const EquilibriumProblem& problem, const EquilibriumTerms& terms, double tolerance) const {
  const double strain = std::clamp(kRoundOffStrain / tolerance, little_strain_, kLittleStrain);
  double scale = std::max(terms.largest_force, strain * model_.wall_stiffness * model_.edge_length);
  for (const Attachment& attachment : problem.attachments) {
    scale = std::max(scale, attachment.force.cwiseAbs().maxCoeff());
  }
  return std::max(scale, round_off(problem, terms) / 1e-9);
}

double Newton::round_off(const EquilibriumProblem& problem, const EquilibriumTerms& terms) const {
  // In a short step the inertia springs are stiff, and carry the round-off of the coordinates, some 1e-16 of them, and
  // that of the fluids' moments.
  double force = 1e-15 * problem.inertia * model_.mass.maxCoeff() * problem.start.lpNorm<Eigen::Infinity>();
  for (std::size_t c = 0; c < problem.fluid_inertia.size(); ++c) {
    const auto first = static_cast<Eigen::Index>(3 * c);
    const double moment = 1e-16 * std::abs(model_.chambers[c].rest_volume) * extent_;  // metres^4
    const double slope = terms.moment_gradient.middleCols<3>(first).lpNorm<Eigen::Infinity>();
    force = std::max(force, problem.fluid_inertia[c].factor * moment * slope);
  }
  return force;
}

double Newton::distance_of(const EquilibriumProblem& problem) const {
  return std::max(0.0, problem.start.lpNorm<Eigen::Infinity>() - 2 * extent_);
}

bool Newton::is_solved(const EquilibriumProblem& problem, const Residual& residual, double force_scale, bool is_stalled,
                       const NewtonOptions& options) const {
  double gap = residual.contact;
  for (const Eigen::Vector3d& one : residual.gaps) gap = std::max(gap, one.norm());
  const double volume_share = is_stalled ? kStalledVolumeShare : kVolumeShare;
  const double volume_tolerance = std::max(kVolumeTolerance, volume_share * options.tolerance);
  const double far = distance_of(problem), round_off = kFarVolume * far * far * far;  // metres, metres^3
  for (Eigen::Index c = 0; c < residual.volume.size(); ++c) {
    const double most = std::max(volume_tolerance * std::abs(model_.chambers[c].rest_volume), round_off);
    if (std::abs(residual.volume[c]) > most) return false;
  }
  // Where forces need not be exact no displacement needs to be that would make a force of that size.
  const double give = options.tolerance * std::min(model_.edge_length, force_scale / model_.wall_stiffness);
  const double gap_tolerance = std::max(kGapTolerance * model_.edge_length, give);
  const double loose = std::max(1.0, std::min(kRoundOffResidual, kLooseResidual / options.tolerance));
  const double slack = is_stalled ? loose : 1;
  // A stiff contact that has come loose by less than gaps may be missed by bears its force all the same.
  const bool are_closed = residual.opening <= gap_tolerance;
  const double ghost = are_closed ? 0 : residual.ghost;
  return std::max(residual.largest_force, ghost) <= slack * options.tolerance * force_scale &&
         gap <= slack * gap_tolerance;
}

bool Newton::has_converged(const EquilibriumProblem& problem, const Residual& residual, const NewtonResult& result,
                           bool is_stalled, const NewtonOptions& options) const {
  // Loads that are light beside what strains the wall a little are answered by one step at least.
  if (result.iterations == 0 &&
      residual.largest_force > unfelt_force(problem, terms_, result.force_scale, options.tolerance)) {
    return false;
  }
  return is_solved(problem, residual, result.force_scale, is_stalled, options);
}

std::string Newton::obstructed(const std::string& reason) const {
  const bool pressed = terms_.folds.energy > 0 && terms_.folds.largest_force == terms_.largest_force;
  return pressed ? reason + ": the wall lies against itself or its floor and is asked to go on" : reason;
}

NewtonResult Newton::solve(EquilibriumProblem& problem, EquilibriumState& state, const NewtonOptions& options) {
  int before = 0;
  factorisations_ = in_single_precision_ = 0;
  ascending_steps_ = 0;
  stepped_to_.resize(0);
  may_be_one_by_one_ = options.borders_contacts;
  may_border_ = options.borders_contacts || !model_.bending.empty();
  keeps_shift_ = options.buckles;
  if (!model_.bending.empty() && !options.buckles) {
    const Start start = started(problem, state);
    NewtonResult result = iterate(problem, state, options, true);
    result.factorisations = factorisations_;
    if (result.converged && !folds_over(start.state.position, state.position)) return result;
    before = result.iterations;
    go_back(start, problem, state);
  }
  shifts_by_tension_ = model_.bending.empty() && problem.fluids.empty() && !options.takes_flaps && problem.inertia == 0;
  NewtonResult result = iterate_held(problem, state, options);
  shifts_by_tension_ = false;
  result.iterations += before;
  result.factorisations = factorisations_;
  result.in_single_precision = in_single_precision_;
  result.ascending_steps = ascending_steps_;
  return result;
}

double Newton::missed(EquilibriumProblem& problem, EquilibriumState& state) {
  if (!begin(problem, state, false)) return std::numeric_limits<double>::infinity();
  compute_residual(problem, state, terms_, trial_residual_);
  return trial_residual_.measure;
}

bool Newton::begin(EquilibriumProblem& problem, EquilibriumState& state, bool with_hessian) {
  foreseen_stress_.clear();
  if (problem.start.size() == 0) problem.start = state.position;
  state.pressure.conservativeResizeLike(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.fluids.size())));
  for (std::size_t c = 0; c < problem.fluids.size(); ++c) {
    if (!problem.fluids[c].is_multiplier()) state.pressure[c] = problem.fluids[c].pressure;
  }
  if (state.rigid_reaction.size() != rigid_columns_.cols()) state.rigid_reaction.setZero(rigid_columns_.cols());
  evaluate_all(problem, state, with_hessian, terms_);
  return std::isfinite(terms_.elastic);
}

double Newton::note_residual(const EquilibriumProblem& problem, const EquilibriumState& state, double tolerance,
                             Residual& residual, NewtonResult& result) const {
  compute_residual(problem, state, terms_, residual);
  result.residual = residual.largest_force;
  result.residual_history.push_back(residual.largest_force);
  result.force_scale = force_scale(problem, terms_, tolerance);
  return result.force_scale;
}

NewtonResult Newton::iterate(EquilibriumProblem& problem, EquilibriumState& state, const NewtonOptions& options,
                             bool foresees) {
  NewtonResult result;
  if (!begin(problem, state, true)) return failed("the wall is stretched beyond its law", result);
  Residual residual;
  Step step;
  double shift = 0, first_scale = 0;
  Progress progress;
  const int most = foresees ? std::min(kForeseeingSteps, options.maximum_iterations) : options.maximum_iterations;
  for (;; ++result.iterations) {
    if (options.between_iterations) options.between_iterations();
    const double scale = note_residual(problem, state, options.tolerance, residual, result);
    progress.note(residual);
    if (result.iterations == 0) first_scale = scale;
    if (has_converged(problem, residual, result, options.takes_flaps && progress.stalled >= kStalledSteps, options)) {
      if (foresees && scale > kBlowUp * first_scale) return failed("the wall is strained beyond measure", result);
      return solved(!is_solved(problem, residual, scale, false, options), result);
    }
    if (result.iterations == most || (foresees && options.takes_flaps && progress.goes_astray())) {
      if (is_solved(problem, residual, scale, options.takes_flaps, options)) return solved(true, result);
      return failed(obstructed("no convergence within " + std::to_string(result.iterations) + " iterations"), result);
    }
    keeps_factor_ = may_keep_factor(problem, residual, options.tolerance * scale, scale, progress);
    progress.kept = keeps_factor_ ? progress.kept + 1 : 0;
    may_end_ = keeps_factor_ || options.borders_contacts || progress.foresees_end(residual, options.tolerance * scale);
    const bool may_be_saddle = options.takes_flaps && progress.inexact >= kInexactSteps;
    shift = shift > kLeastShift && !may_be_saddle ? 0.1 * shift : 0;
    if (!find_step_with_contacts(problem, state, residual, shift, may_be_saddle, step)) {
      return failed("no convex step could be found", result);
    }
    if (shift > 0) ++result.shifted_iterations;
    result.is_convex = is_exact_ && is_convex_;
    progress.takes_saddle = may_be_saddle && is_exact_;
    if (!progress.takes_saddle) progress.inexact = is_exact_ ? 0 : progress.inexact + 1;
    if (foresees) {
      if (take_whole(problem, state, residual, step)) continue;
      return failed("the wall is stretched beyond its law", result);
    }
    progress.descent = search(problem, state, residual, step, progress.tries_whole_step(result.iterations) ? 1 : 0.5);
    if (progress.descent != Descent::kNone) {
      note_step(step, state);
      if (may_relax_patches(problem, options, result.iterations)) relax_patches(problem, state, options);
      continue;
    }
    stepped_to_.resize(0);
    if (may_be_saddle) progress.inexact = 0;
    if (may_be_saddle || keeps_factor_) continue;
    if (is_solved(problem, residual, scale, options.takes_flaps, options)) return solved(true, result);
    return failed(obstructed("the line search found no smaller residual or energy"), result);
  }
}

void Newton::note_step(const Step& step, const EquilibriumState& state) {
  const bool is_small = step.position.lpNorm<Eigen::Infinity>() < kSmallStep * model_.edge_length;
  if (is_exact_ && is_small) stepped_to_ = state.position;
}

}  // namespace thinwall
