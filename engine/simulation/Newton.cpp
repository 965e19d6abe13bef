#include "engine/simulation/Newton.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

/// Anchor springs of a free body, as a multiple of the wall's stiffness: any positive value gives the same solution.
constexpr double kAnchorStiffness = 1;

/// Gamma over the largest diagonal entry: large enough for Uzawa's iteration to gain some four digits a turn, small
/// enough to cost no more of the factor's digits.
constexpr double kAttachmentStiffness = 1e4;

/// Part of the contacts' push that contacts may pull in a step: those at the rim open by themselves in the next one.
constexpr double kToleratedPull = 0.1;

/// How often a step may be found again because contacts would pull or be overrun.
constexpr int kContactTurns = 8;

/// After this many iterations steps are halved at once: whole ones may go to and fro between two sets of contacts, one
/// of which lowers the residual and the other the energy.
constexpr int kWholeSteps = 15;

/// Steps of a shell without line search before it is solved with one.
constexpr int kForeseeingSteps = 40;

double square(double value) {
  return value * value;
}

bool is_multiplier(const FluidProblem& fluid) {
  return fluid.mode != FluidMode::kGivenPressure;
}

/// Volume by which a compressible fluid gives way to a pascal, metres^3; zero for others.
double compliance(const FluidProblem& fluid) {
  return fluid.mode == FluidMode::kCompressible ? fluid.fluid_volume / fluid.bulk_modulus : 0;
}

}  // namespace

Newton::Newton(const BodyModel& model)
    : model_(model),
      factor_(model.pattern),
      self_contact_(self_contact_of(model)),
      fold_matrix_(model),
      rigid_columns_(model.rigid_motions) {
  for (Eigen::Index k = 0; k < rigid_columns_.rows(); ++k) rigid_columns_.row(k) *= model.mass[k] / model.mass.mean();
}

void Newton::evaluate_all(const EquilibriumProblem& problem, const EquilibriumState& state, EquilibriumTerms& terms) {
  evaluate(model_, problem, state.position, state.pressure, terms);
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
  if (!problem.fluids.empty()) residual.force -= terms.volume_gradient * state.pressure;
  residual.gaps.clear();
  for (const Attachment& attachment : problem.attachments) {
    for (int k = 0; k < 3; ++k) {
      residual.force.segment<3>(3 * attachment.vertices[k]) += attachment.weights[k] * attachment.force;
    }
    residual.gaps.push_back(
        attachment.prescribed.cwiseProduct(material_point(attachment, state.position) - attachment.target));
  }
  residual.contact = residual.ghost = 0;
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
    if (contact_law(contact) <= 0) residual.ghost = std::max(residual.ghost, force);
  }
  if (problem.hold_rigid_motions) {
    residual.force += rigid_columns_ * state.rigid_reaction;
    residual.rigid = rigid_columns_.transpose() * (state.position - model_.rest_position);
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
  residual.volume.setZero(static_cast<Eigen::Index>(problem.fluids.size()));
  for (std::size_t c = 0; c < problem.fluids.size(); ++c) {
    const FluidProblem& fluid = problem.fluids[c];
    if (!is_multiplier(fluid)) continue;
    residual.volume[c] =
        terms.volume[c] - fluid.fluid_volume + compliance(fluid) * (state.pressure[c] - fluid.pressure);
  }
  if (problem.orifice_time == 0) return;
  for (const OrificeDefinition& orifice : model_.definition.fluid.orifices) {
    const double flown = problem.orifice_time * flow_between(model_, orifice, problem.gravity, state.pressure).rate;
    if (is_multiplier(problem.fluids[orifice.from])) residual.volume[orifice.from] += flown;
    if (is_multiplier(problem.fluids[orifice.to])) residual.volume[orifice.to] -= flown;
  }
}

void Newton::clear_fixed(Eigen::VectorXd& forces) const {
  for (Eigen::Index k = 0; k < forces.size(); ++k) {
    if (model_.fixed[k]) forces[k] = 0;
  }
}

double Newton::force_scale(const EquilibriumProblem& problem, const EquilibriumTerms& terms) const {
  // An unstressed wall still carries the round-off of its coordinates, some 1e-14 of strain.
  double scale = std::max(terms.largest_force, 1e-4 * model_.wall_stiffness * model_.edge_length);
  for (const Attachment& attachment : problem.attachments) {
    scale = std::max(scale, attachment.force.cwiseAbs().maxCoeff());
  }
  // In a short step the inertia springs are stiff, and carry the round-off of the coordinates, some 1e-16 of them.
  const double round_off = 1e-15 * problem.inertia * model_.mass.maxCoeff() * problem.start.lpNorm<Eigen::Infinity>();
  return std::max(scale, round_off / 1e-9);
}

bool Newton::is_solved(const Residual& residual, double force_scale, const NewtonOptions& options) const {
  double gap = residual.contact;
  for (const Eigen::Vector3d& one : residual.gaps) gap = std::max(gap, one.norm());
  for (Eigen::Index c = 0; c < residual.volume.size(); ++c) {
    if (std::abs(residual.volume[c]) > 1e-11 * std::abs(model_.chambers[c].rest_volume)) return false;
  }
  return std::max(residual.largest_force, residual.ghost) <= options.tolerance * force_scale &&
         gap <= 1e-9 * model_.edge_length;
}

void Newton::border_fluids(const EquilibriumProblem& problem, const EquilibriumState& state) {
  std::vector<int> column(problem.fluids.size(), -1);
  for (std::size_t k = 0; k < bordering_.size(); ++k) {
    const int chamber = bordering_[k];
    column[chamber] = static_cast<int>(k);
    border_.col(k) = -terms_.volume_gradient.col(chamber);
    corner_(k, k) = -compliance(problem.fluids[chamber]);
  }
  if (problem.orifice_time == 0) return;
  for (const OrificeDefinition& orifice : model_.definition.fluid.orifices) {
    const double slope = problem.orifice_time * flow_between(model_, orifice, problem.gravity, state.pressure).slope;
    const int from = column[orifice.from], to = column[orifice.to];
    if (from >= 0) corner_(from, from) -= slope;
    if (to >= 0) corner_(to, to) -= slope;
    if (from < 0 || to < 0) continue;
    corner_(from, to) += slope;
    corner_(to, from) += slope;
  }
}

void Newton::build_border(const EquilibriumProblem& problem, const EquilibriumState& state) {
  bordering_.clear();
  for (std::size_t c = 0; c < problem.fluids.size(); ++c) {
    if (is_multiplier(problem.fluids[c])) bordering_.push_back(static_cast<int>(c));
  }
  const auto fluid = static_cast<Eigen::Index>(bordering_.size());
  const Eigen::Index rigid = problem.hold_rigid_motions ? rigid_columns_.cols() : 0;
  const Eigen::Index anchors = problem.hold_rigid_motions ? static_cast<Eigen::Index>(model_.anchors.size()) : 0;
  const auto moving = static_cast<Eigen::Index>(3 * problem.fluid_inertia.size());
  border_.setZero(terms_.gradient.size(), fluid + rigid + moving + anchors);
  corner_.setZero(border_.cols(), border_.cols());
  constraints_ = static_cast<int>(fluid + rigid + moving);
  border_fluids(problem, state);
  if (rigid > 0) border_.middleCols(fluid, rigid) = rigid_columns_;
  // Springs on the fluid's moments couple all vertices; as columns of the border they leave the matrix sparse.
  for (Eigen::Index k = 0; k < moving; ++k) {
    border_.col(fluid + rigid + k) = terms_.moment_gradient.col(k);
    corner_(fluid + rigid + k, fluid + rigid + k) = -1 / problem.fluid_inertia[k / 3].factor;
  }
  // The anchor springs in the factorised matrix are taken back here, exactly.
  for (Eigen::Index k = 0; k < anchors; ++k) {
    const Eigen::Index column = fluid + rigid + moving + k;
    border_(model_.anchors[k], column) = -1;
    corner_(column, column) = 1 / (kAnchorStiffness * model_.wall_stiffness);
  }
  for (Eigen::Index k = 0; k < border_.rows(); ++k) {
    if (model_.fixed[k]) border_.row(k).setZero();
  }
}

void Newton::build_matrix(const EquilibriumProblem& problem, const EquilibriumState& state, double shift) {
  matrix_ = terms_.values;
  add_foreseen(problem, state.position);
  double diagonal = 0;
  for (std::size_t k = 0; k < model_.diagonal_entries.size(); ++k) {
    double& value = matrix_[model_.diagonal_entries[k]];
    diagonal = std::max(diagonal, std::abs(value));
    value += problem.inertia * model_.mass[static_cast<Eigen::Index>(k)] + shift * model_.wall_stiffness;
  }
  if (problem.hold_rigid_motions) {
    for (const int anchor : model_.anchors) {
      matrix_[model_.diagonal_entries[anchor]] += kAnchorStiffness * model_.wall_stiffness;
    }
  }
  for (std::size_t k = 0; k < terms_.contacts.size(); ++k) {
    if (open_[k]) continue;
    const ContactPoint& contact = terms_.contacts[k];
    add_triangle(model_.addresses[contact.triangle],
                 contact.potential.stiffness * contact.gap.gradient * contact.gap.gradient.transpose() -
                     contact_force(problem, contact) * contact.gap.hessian,
                 matrix_);
  }
  add_floors(model_, terms_.folds, matrix_);
  attachment_stiffness_ = kAttachmentStiffness * diagonal;
  for (const Attachment& attachment : problem.attachments) {
    Eigen::Matrix<double, 9, 9> outer;
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        outer.block<3, 3>(3 * a, 3 * b) = attachment_stiffness_ * attachment.weights[a] * attachment.weights[b] *
                                          attachment.prescribed.asDiagonal().toDenseMatrix();
      }
    }
    add_triangle(triangle_addresses(model_.pattern, attachment.vertices), outer, matrix_);
  }
  for (const int entry : model_.fixed_entries) matrix_[entry] = 0;
  for (std::size_t k = 0; k < model_.diagonal_entries.size(); ++k) {
    if (model_.fixed[k]) matrix_[model_.diagonal_entries[k]] = model_.wall_stiffness;
  }
}

bool Newton::is_convex(SparseFactor& factor, std::span<const double> values) {
  std::optional<int> negative;
  if (factor.factorize(values)) {
    negative = 0;
  } else if (constraints_ > 0) {
    negative = factor.factorize_indefinite(values);
  }
  if (!negative) return false;
  bordered_.set(factor, *negative, border_, corner_);
  return bordered_.negative_eigenvalues() == constraints_;
}

bool Newton::factorize(const EquilibriumProblem& problem, const EquilibriumState& state, double& shift) {
  build_border(problem, state);
  folded_ = fold_matrix_.prepare(terms_.folds, self_contact_);
  bool exact = shift == 0;
  for (int attempt = 0; attempt < 20; ++attempt) {
    build_matrix(problem, state, shift);
    const bool convex = folded_ ? is_convex(fold_matrix_.factor(), fold_matrix_.assemble(matrix_, terms_.folds, exact))
                                : is_convex(factor_, matrix_);
    if (convex) return true;
    if (!folded_ || !exact) shift = shift == 0 ? 1e-6 : 10 * shift;
    exact = false;
  }
  return false;
}

void Newton::find_step(const EquilibriumProblem& problem, const Residual& residual, Step& step) {
  Eigen::VectorXd force = -residual.force;
  // The step is taken from the contact's law, not from the multiplier that enters the residual.
  for (std::size_t k = 0; k < terms_.contacts.size(); ++k) {
    const ContactPoint& contact = terms_.contacts[k];
    const double push = (open_[k] ? 0 : contact_law(contact)) - contact_force(problem, contact);
    for (int c = 0; c < 3; ++c) {
      force.segment<3>(3 * model_.surface[contact.triangle][c]) += push * contact.gap.gradient.segment<3>(3 * c);
    }
  }
  step.forces.assign(problem.attachments.size(), Eigen::Vector3d::Zero());
  Eigen::VectorXd multipliers;
  const Eigen::Index rigid = problem.hold_rigid_motions ? rigid_columns_.cols() : 0;
  const auto fluid = static_cast<Eigen::Index>(bordering_.size());
  for (int turn = 0;; ++turn) {
    step.position = force;
    for (std::size_t k = 0; k < problem.attachments.size(); ++k) {
      const Attachment& attachment = problem.attachments[k];
      const Eigen::Vector3d pull = step.forces[k] + attachment_stiffness_ * residual.gaps[k];
      for (int a = 0; a < 3; ++a) step.position.segment<3>(3 * attachment.vertices[a]) -= attachment.weights[a] * pull;
    }
    clear_fixed(step.position);
    multipliers.setZero(border_.cols());
    for (Eigen::Index k = 0; k < fluid; ++k) multipliers[k] = residual.volume[bordering_[k]];
    if (rigid > 0) multipliers.segment(fluid, rigid) = -residual.rigid;
    bordered_.solve(used_factor(), step.position, multipliers);
    double error = 0;
    for (std::size_t k = 0; k < problem.attachments.size(); ++k) {
      const Attachment& attachment = problem.attachments[k];
      const Eigen::Vector3d gap =
          residual.gaps[k] + attachment.prescribed.cwiseProduct(material_point(attachment, step.position));
      step.forces[k] += attachment_stiffness_ * gap;
      error = std::max(error, gap.norm());
    }
    if (error <= 1e-14 * model_.edge_length || turn == 5 || problem.attachments.empty()) break;
  }
  step.pressure.setZero(residual.volume.size());
  for (Eigen::Index k = 0; k < fluid; ++k) step.pressure[bordering_[k]] = multipliers[k];
  step.rigid = multipliers.segment(fluid, rigid);
  for (std::size_t k = 0; k < problem.attachments.size(); ++k) step.forces[k] += problem.attachments[k].force;
  find_contact_forces(step);
}

void Newton::find_contact_forces(Step& step) const {
  step.contact_forces.clear();
  for (const ContactPoint& contact : terms_.contacts) {
    const double opening = gap_change(contact, step.position);
    step.contact_forces.push_back(contact_law(contact) - contact.potential.stiffness * opening);
  }
}

bool Newton::revise_contacts(const Step& step) {
  double push = 0, wrong = 0;  // newton
  for (std::size_t k = 0; k < open_.size(); ++k) {
    const double force = step.contact_forces[k];
    const bool presses = force > 0;
    if (presses == static_cast<bool>(open_[k])) {
      wrong += std::abs(force);
    } else if (presses) {
      push += force;
    }
  }
  if (wrong <= kToleratedPull * push) return false;
  for (std::size_t k = 0; k < open_.size(); ++k) open_[k] = step.contact_forces[k] <= 0;
  return true;
}

double Newton::gap_change(const ContactPoint& contact, const Eigen::VectorXd& motion) const {
  double change = 0;
  for (int k = 0; k < 3; ++k) {
    change += contact.gap.gradient.segment<3>(3 * k).dot(motion.segment<3>(3 * model_.surface[contact.triangle][k]));
  }
  return change;
}

double Newton::merit(const EquilibriumProblem& problem, const EquilibriumState& state, const EquilibriumTerms& terms,
                     const Residual& residual, const Weights& weights) const {
  double value = terms.elastic + terms.bending + terms.folds.energy + terms.gravity - terms.load_work + terms.inertial +
                 terms.friction + weights.pressure * residual.volume.lpNorm<1>();
  for (std::size_t c = 0; c < problem.fluids.size(); ++c) {
    const FluidProblem& fluid = problem.fluids[c];
    if (fluid.mode == FluidMode::kGivenPressure) value -= fluid.pressure * terms.volume[c];
    value += 0.5 * compliance(fluid) * square(state.pressure[c]);
  }
  for (const Eigen::Vector3d& gap : residual.gaps) value += weights.force * gap.norm();
  for (const ContactPoint& contact : terms.contacts) {
    value += weights.contact * std::max(0.0, contact.potential.onset - contact.gap.gap);
  }
  return value;
}

double Newton::merit_slope(const EquilibriumProblem& problem, const EquilibriumState& state, const Residual& residual,
                           const Step& step, const Weights& weights) const {
  Eigen::VectorXd smooth = residual.force;
  if (problem.hold_rigid_motions) smooth -= rigid_columns_ * state.rigid_reaction;
  double slope = -weights.pressure * residual.volume.lpNorm<1>();
  for (std::size_t c = 0; c < problem.fluids.size(); ++c) {
    if (is_multiplier(problem.fluids[c])) smooth += state.pressure[c] * terms_.volume_gradient.col(c);
    slope += compliance(problem.fluids[c]) * state.pressure[c] * step.pressure[c];
  }
  slope += smooth.dot(step.position);
  for (std::size_t k = 0; k < residual.gaps.size(); ++k) {
    slope -= problem.attachments[k].force.dot(material_point(problem.attachments[k], step.position)) +
             weights.force * residual.gaps[k].norm();
  }
  for (const ContactPoint& contact : terms_.contacts) {
    slope += contact_force(problem, contact) * gap_change(contact, step.position) -
             weights.contact * std::max(0.0, contact.potential.onset - contact.gap.gap);
  }
  return slope;
}

std::string Newton::obstructed(const std::string& reason) const {
  const bool pressed = terms_.folds.energy > 0 && terms_.folds.largest_force == terms_.largest_force;
  return pressed ? reason + ": the wall lies against itself or its floor and is asked to go on" : reason;
}

bool Newton::search(EquilibriumProblem& problem, EquilibriumState& state, Residual& residual, const Step& step,
                    double fraction) {
  // Weights above the multipliers make the merit function exact: its minimum is the constrained one.
  Weights weights{.pressure = 2 * (state.pressure + step.pressure).lpNorm<Eigen::Infinity>(), .force = 0, .contact = 0};
  for (const Eigen::Vector3d& force : step.forces) weights.force = std::max(weights.force, 2 * force.norm());
  for (const double force : step.contact_forces) weights.contact = std::max(weights.contact, 2 * force);
  const double before = merit(problem, state, terms_, residual, weights);
  const double slope = merit_slope(problem, state, residual, step, weights);
  const Start start{
      .state = state, .attachments = problem.attachments, .solids = problem.solids, .friction = problem.friction};
  Residual trial;
  fraction = std::min(fraction, self_contact_.safe_fraction(start.state.position, step.position));
  for (int halving = 0; halving < 16; ++halving, fraction *= 0.5) {
    place(start, step, fraction, problem, state);
    if (!std::isfinite(trial_terms_.elastic)) continue;
    compute_residual(problem, state, trial_terms_, trial);
    const bool residual_fell = trial.measure <= (1 - 0.1 * fraction) * residual.measure;
    const bool merit_fell = merit(problem, state, trial_terms_, trial, weights) <= before + 1e-4 * fraction * slope;
    if (residual_fell || merit_fell) {
      std::swap(terms_, trial_terms_);
      return true;
    }
  }
  state = start.state;
  problem.attachments = start.attachments;
  problem.solids = start.solids;
  problem.friction = start.friction;
  return false;
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
  evaluate_all(problem, state, trial_terms_);
}

bool Newton::take_whole(EquilibriumProblem& problem, EquilibriumState& state, Residual& residual, const Step& step) {
  const Start start{
      .state = state, .attachments = problem.attachments, .solids = problem.solids, .friction = problem.friction};
  const double fraction = std::min(1.0, self_contact_.safe_fraction(state.position, step.position));
  foresee(problem, state.position, fraction * step.position);
  place(start, step, fraction, problem, state);
  if (!std::isfinite(trial_terms_.elastic) || !std::isfinite(trial_terms_.bending)) return false;
  compute_residual(problem, state, trial_terms_, residual);
  std::swap(terms_, trial_terms_);
  return true;
}

void Newton::foresee(const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                     const Eigen::VectorXd& motion) {
  foreseen_stress_.resize(model_.bending.size());
  for (int t = 0; t < static_cast<int>(foreseen_stress_.size()); ++t) {
    foreseen_stress_[t] = membrane_stress(model_.rest[t], model_.material(t), corners_of(model_.surface[t], position),
                                          corners_of(model_.surface[t], motion), problem.memory.of(t))
                              .foreseen;
  }
}

void Newton::add_foreseen(const EquilibriumProblem& problem, const Eigen::VectorXd& position) {
  for (int t = 0; t < static_cast<int>(foreseen_stress_.size()); ++t) {
    const auto corners = corners_of(model_.surface[t], position);
    const Eigen::Vector3d now =
        membrane_stress(model_.rest[t], model_.material(t), corners, corners, problem.memory.of(t)).now;
    add_triangle(model_.addresses[t], geometric_stiffness(model_.rest[t], foreseen_stress_[t] - now), matrix_);
  }
}

NewtonResult Newton::solve(EquilibriumProblem& problem, EquilibriumState& state, const NewtonOptions& options) {
  int before = 0;
  if (!model_.bending.empty()) {
    const Start start{
        .state = state, .attachments = problem.attachments, .solids = problem.solids, .friction = problem.friction};
    NewtonResult result = iterate(problem, state, options, true);
    if (result.converged) return result;
    before = result.iterations;
    state = start.state;
    problem.attachments = start.attachments;
    problem.solids = start.solids;
    problem.friction = start.friction;
  }
  NewtonResult result = iterate(problem, state, options, false);
  result.iterations += before;
  return result;
}

NewtonResult Newton::iterate(EquilibriumProblem& problem, EquilibriumState& state, const NewtonOptions& options,
                             bool foresees) {
  NewtonResult result;
  foreseen_stress_.clear();
  if (problem.start.size() == 0) problem.start = state.position;
  state.pressure.conservativeResizeLike(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.fluids.size())));
  for (std::size_t c = 0; c < problem.fluids.size(); ++c) {
    if (!is_multiplier(problem.fluids[c])) state.pressure[c] = problem.fluids[c].pressure;
  }
  if (state.rigid_reaction.size() != rigid_columns_.cols()) state.rigid_reaction.setZero(rigid_columns_.cols());
  evaluate_all(problem, state, terms_);
  if (!std::isfinite(terms_.elastic)) {
    result.reason = "the wall is stretched beyond its law";
    return result;
  }
  Residual residual;
  Step step;
  double shift = 0;
  for (;; ++result.iterations) {
    if (options.between_iterations) options.between_iterations();
    compute_residual(problem, state, terms_, residual);
    result.residual = residual.largest_force;
    result.residual_history.push_back(residual.largest_force);
    if (is_solved(residual, force_scale(problem, terms_), options)) {
      result.converged = true;
      return result;
    }
    if (result.iterations == (foresees ? kForeseeingSteps : options.maximum_iterations)) {
      result.reason = obstructed("no convergence within " + std::to_string(options.maximum_iterations) + " iterations");
      return result;
    }
    shift = shift > 1e-6 ? 0.1 * shift : 0;
    open_.clear();
    for (const ContactPoint& contact : terms_.contacts) {
      // Edges and faces bear what vertices leave to them: whether that is so the step itself shows.
      const bool may_wait = contact_law(contact) <= 0 || model_.sites[contact.site].part != SitePart::kCorner;
      open_.push_back(contact_force(problem, contact) == 0 && may_wait);
    }
    for (int turn = 0;; ++turn) {
      if (!factorize(problem, state, shift)) {
        result.reason = "no convex step could be found";
        return result;
      }
      find_step(problem, residual, step);
      if (turn == kContactTurns || !revise_contacts(step)) break;
    }
    for (std::size_t k = 0; k < open_.size(); ++k) {
      step.contact_forces[k] = open_[k] ? 0 : std::max(0.0, step.contact_forces[k]);
    }
    if (shift > 0) ++result.shifted_iterations;
    if (foresees) {
      if (take_whole(problem, state, residual, step)) continue;
      result.reason = "the wall is stretched beyond its law";
      return result;
    }
    if (!search(problem, state, residual, step, result.iterations < kWholeSteps ? 1 : 0.5)) {
      result.reason = obstructed("the line search found no smaller residual or energy");
      return result;
    }
  }
}

}  // namespace thinwall
