#include "engine/equilibrium/Newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/equilibrium/OpenChambers.hpp"

namespace thinwall {
namespace {

/// Anchor springs of a free body, as a multiple of the wall's stiffness: any positive value gives the same solution.
constexpr double kAnchorStiffness = 1;

/// Gamma over the largest diagonal entry: large enough for Uzawa's iteration to gain some four digits a turn, small
/// enough to cost no more of the factor's digits.
constexpr double kAttachmentStiffness = 1e4;

/// Part of the shift that a matrix needed last with which the next one is tried that is not convex.
constexpr double kKeptShift = 0.3;

/// Turns of Uzawa's iteration after the first.
constexpr int kUzawaTurns = 5;

/// Springs beside a tension that makes a matrix convex, as part of it: what moves as a whole no tension holds.
constexpr double kSpringsBesideTension = 1e-3;

}  // namespace

void Newton::border_fluids(const EquilibriumProblem& problem, const EquilibriumState& state) {
  std::vector<int> column(problem.fluids.size(), -1);
  for (std::size_t k = 0; k < bordering_.size(); ++k) {
    const int chamber = bordering_[k];
    column[chamber] = static_cast<int>(k);
    border_.col(k) = -terms_.volume_gradient.col(chamber);
    corner_(k, k) = -problem.fluids[chamber].compliance(state.pressure[chamber]);
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
    if (problem.fluids[c].is_multiplier()) bordering_.push_back(static_cast<int>(c));
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
  if (model_.has_open_chambers()) border_openings(problem, state);
}

void Newton::border_openings(const EquilibriumProblem& problem, const EquilibriumState& state) {
  columns_ = rows_ = border_;
  for (std::size_t k = 0; k < bordering_.size(); ++k) {
    const int chamber = bordering_[k];
    if (!model_.is_open(chamber)) continue;
    const auto column = static_cast<Eigen::Index>(k);
    const OpeningEquation equation =
        opening_equation(model_, problem, terms_, chamber, state.position, state.pressure, true);
    columns_.col(column) = -terms_.pressure_load.col(chamber);
    // Where a crumpled wall lies inside out at the surface it would sink as the pressure rises: the step seeks a level
    // where it does not.
    corner_(column, column) -= std::abs(terms_.filled_by_pressure[chamber]);
    const bool has_air = problem.fluids[chamber].vent >= 0;
    // Where there is air the pressure is given: for the question of convexity it is no constraint of the volume.
    if (has_air) {
      border_.col(column).setZero();
      rows_.col(column).setZero();
      corner_.row(column).setZero();
    }
    rows_.col(column) -= equation.by_position;
    corner_(column, column) -= equation.by_pressure;
  }
  const auto first = static_cast<Eigen::Index>(constraints_) - terms_.moment_load.cols();
  columns_.middleCols(first, terms_.moment_load.cols()) = terms_.moment_load;
}

void Newton::add_tension(double shift) {
  for (int t = 0; t < static_cast<int>(model_.rest.size()); ++t) {
    const double tension = shift * model_.wall_stiffness / model_.rest[t].thickness;  // pascal
    add_triangle(model_.addresses[t], geometric_stiffness(model_.rest[t], {tension, tension, 0}), matrix_);
  }
}

void Newton::build_matrix(const EquilibriumProblem& problem, const EquilibriumState& state, double shift) {
  matrix_ = terms_.values;
  add_foreseen(problem, state.position);
  add_changed_shafts(problem, state);
  double diagonal = 0;
  const double springs = shifts_by_tension_ ? kSpringsBesideTension * shift : shift;
  for (std::size_t k = 0; k < model_.diagonal_entries.size(); ++k) {
    double& value = matrix_[model_.diagonal_entries[k]];
    diagonal = std::max(diagonal, std::abs(value));
    value += problem.inertia * model_.mass[static_cast<Eigen::Index>(k)] + springs * model_.wall_stiffness;
  }
  if (shifts_by_tension_ && shift > 0) add_tension(shift);
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

bool Newton::factorize(const EquilibriumProblem& problem, const EquilibriumState& state, const Residual* residual,
                       double& shift, bool may_be_saddle) {
  if (!terms_.has_hessian()) evaluate_all(problem, state, true, terms_);
  build_border(problem, state);
  own_columns_ = border_.cols();
  factorised_open_ = open_;
  factorised_contacts_ = terms_.contacts;
  solved_contacts_.clear();
  folded_ = fold_matrix_.prepare(terms_.folds, self_contact_);
  bool exact = shift == 0;
  for (int attempt = 0; attempt < 20; ++attempt) {
    build_matrix(problem, state, shift);
    Eigen::VectorXd expected;
    if (residual != nullptr) {
      const std::vector<Eigen::Vector3d> unchanged(problem.attachments.size(), Eigen::Vector3d::Zero());
      expected = with_pulls(problem, force_of_step(problem, state, *residual), residual, unchanged);
    }
    is_exact_ = shift == 0 && exact;
    const std::span<const double> values =
        folded_ ? fold_matrix_.assemble(matrix_, terms_.folds, exact) : std::span<const double>(matrix_);
    const bool usable = takes_single_precision(problem, expected)
                            ? is_usable_in_single(values, expected, may_be_saddle)
                            : is_usable(values, expected, may_be_saddle, Precision::kDouble);
    if (usable) {
      if (shift > 0) last_shift_ = shift;
      return true;
    }
    const double first = std::max(kLeastShift, keeps_shift_ ? kKeptShift * last_shift_ : 0);
    if (!folded_ || !exact) shift = shift == 0 ? first : 10 * shift;
    exact = false;
  }
  return false;
}

Eigen::VectorXd Newton::with_pulls(const EquilibriumProblem& problem, const Eigen::VectorXd& force,
                                   const Residual* missed, const std::vector<Eigen::Vector3d>& changes) const {
  Eigen::VectorXd all = force;
  for (std::size_t k = 0; k < problem.attachments.size(); ++k) {
    const Attachment& attachment = problem.attachments[k];
    Eigen::Vector3d pull = changes[k];
    if (missed != nullptr) pull += attachment_stiffness_ * missed->gaps[k];
    for (int a = 0; a < 3; ++a) all.segment<3>(3 * attachment.vertices[a]) -= attachment.weights[a] * pull;
  }
  clear_fixed(all);
  return all;
}

void Newton::solve_linear(const EquilibriumProblem& problem, const Eigen::VectorXd& force, const Residual* missed,
                          Step& step) {
  const auto attachments = static_cast<int>(problem.attachments.size());
  step.forces.assign(attachments, Eigen::Vector3d::Zero());
  Eigen::VectorXd multipliers;
  double error = 0;
  for (int turn = 0; turn == 0 || (turn <= kUzawaTurns && error > 1e-14 * model_.edge_length); ++turn) {
    step.position = with_pulls(problem, force, missed, step.forces);
    multipliers = missed_constraints(problem, missed);
    bordered_.solve(used_factor(), step.position, multipliers);
    error = 0;
    for (int k = 0; k < attachments; ++k) {
      const Attachment& attachment = problem.attachments[k];
      Eigen::Vector3d gap = attachment.prescribed.cwiseProduct(material_point(attachment, step.position));
      if (missed != nullptr) gap += missed->gaps[k];
      step.forces[k] += attachment_stiffness_ * gap;
      error = std::max(error, gap.norm());
    }
  }
  set_multipliers(problem, std::move(multipliers), step);
}

Eigen::VectorXd Newton::missed_constraints(const EquilibriumProblem& problem, const Residual* missed) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(border_.cols());
  if (missed == nullptr) return all;
  const auto fluid = static_cast<Eigen::Index>(bordering_.size());
  for (Eigen::Index k = 0; k < fluid; ++k) all[k] = missed->volume[bordering_[k]];
  if (problem.hold_rigid_motions) all.segment(fluid, rigid_columns_.cols()) = -missed->rigid;
  return all;
}

void Newton::set_multipliers(const EquilibriumProblem& problem, Eigen::VectorXd multipliers, Step& step) const {
  const auto fluid = static_cast<Eigen::Index>(bordering_.size());
  step.pressure.setZero(static_cast<Eigen::Index>(problem.fluids.size()));
  for (Eigen::Index k = 0; k < fluid; ++k) step.pressure[bordering_[k]] = multipliers[k];
  step.rigid = multipliers.segment(fluid, problem.hold_rigid_motions ? rigid_columns_.cols() : 0);
  step.multipliers = std::move(multipliers);
}

Eigen::VectorXd Newton::force_of_step(const EquilibriumProblem& problem, const EquilibriumState& state,
                                      const Residual& residual) const {
  Eigen::VectorXd force = changed_shaft_force(problem, state) - residual.force;
  // The step is taken from the contact's law, not from the multiplier that enters the residual.
  for (std::size_t k = 0; k < terms_.contacts.size(); ++k) {
    const ContactPoint& contact = terms_.contacts[k];
    const double push = (open_[k] ? 0 : contact_law(contact)) - contact_force(problem, contact);
    // Along its spring in the matrix: with another the stiffness would make an error of it.
    const ContactPoint& spring = open_[k] ? contact : factorised_contacts_[k];
    for (int c = 0; c < 3; ++c) {
      force.segment<3>(3 * model_.surface[contact.triangle][c]) += push * spring.gap.gradient.segment<3>(3 * c);
    }
  }
  return force;
}

void Newton::find_step(const EquilibriumProblem& problem, const EquilibriumState& state, const Residual& residual,
                       Step& step) {
  Eigen::VectorXd force = force_of_step(problem, state, residual);
  solve_linear(problem, force, &residual, step);
  if (model_.has_open_chambers()) {
    Step from_rims;
    const Eigen::VectorXd left_out = left_out_at_rims(problem, state, step);
    solve_linear(problem, left_out, nullptr, from_rims);
    force += left_out;
    step.position += from_rims.position;
    set_multipliers(problem, step.multipliers + from_rims.multipliers, step);
    for (std::size_t k = 0; k < step.forces.size(); ++k) step.forces[k] += from_rims.forces[k];
  }
  refine_step(problem, force, &residual, step);
  for (std::size_t k = 0; k < problem.attachments.size(); ++k) step.forces[k] += problem.attachments[k].force;
  find_contact_forces(step);
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

}  // namespace thinwall
