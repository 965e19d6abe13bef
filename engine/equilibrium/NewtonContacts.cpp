#include "engine/equilibrium/Newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace thinwall {
namespace {

/// How often a step may be found again because contacts would pull or be overrun.
constexpr int kContactTurns = 8;
constexpr int kBorderedContactTurns = 40;  // where that costs little

/// Contacts of a membrane that may border its matrix: more of them cost as much as to factorise it again.
constexpr std::size_t kMostBordered = 32;

/// Part of the contacts' push that contacts may pull in a step: those at the rim open by themselves in the next one.
constexpr double kToleratedPull = 0.1;

/// Part of the coordinates below which a gap is round-off.
constexpr double kRoundOffGap = 1e-15;

/// Whether what contacts give is lost in the round-off of how far the factorised matrix gives way, as that of a body
/// that only contacts hold which it is without: its rigid motions, which borders keep out, then cost next to nothing. A
/// factor misses a part of a motion that goes with how much softer that is than the wall. `border`, `solved`: before
/// contacts are added, and solved with the factor. `stiffest`, `wall_stiffness`: newton / metre.
bool is_give_lost(const Eigen::Ref<const Eigen::MatrixXd>& border, const Eigen::Ref<const Eigen::MatrixXd>& solved,
                  double stiffest, double wall_stiffness) {
  double softest = 0;  // metres / newton
  for (Eigen::Index k = 0; k < border.cols(); ++k) {
    softest = std::max(softest, std::abs(border.col(k).dot(solved.col(k))));
  }
  const double missed_part = std::numeric_limits<double>::epsilon() * wall_stiffness * softest;
  return missed_part * softest * stiffest > 1;
}

}  // namespace

bool Newton::find_step_with_contacts(const EquilibriumProblem& problem, const EquilibriumState& state,
                                     const Residual& residual, double& shift, bool may_be_saddle, Step& step) {
  open_.clear();
  const double round_off = kRoundOffGap * state.position.lpNorm<Eigen::Infinity>();  // metres
  for (const ContactPoint& contact : terms_.contacts) {
    // Edges and faces bear what vertices leave to them: whether that is so the step itself shows. A vertex that bears
    // nothing and lies where it would bear nothing is free, as far as coordinates can tell: held, it could not leave by
    // less than they resolve, and its share of the residual would stay.
    const bool bears_nothing = contact_law(contact) <= contact.potential.stiffness * round_off;
    const bool may_wait = bears_nothing || model_.sites[contact.site].part != SitePart::kCorner;
    open_.push_back(contact_force(problem, contact) == 0 && may_wait);
  }
  begin_shafts(problem, state);
  bool are_shafts_revised = false;
  ContactTurns turns;
  turns.may_be_one_by_one = may_be_one_by_one_;
  for (const ContactPoint& contact : terms_.contacts) turns.forces.push_back(contact_force(problem, contact));
  for (int turn = 0;; ++turn) {
    // A membrane's matrix costs little where time does not matter, and without the curvature that contacts take along
    // its needles find no way. What was made convex without the contacts that close may be so with them by itself.
    const bool has_factor = keeps_factor_ || turn > 0;
    const bool is_enough = has_factor && !are_shafts_revised && !may_be_saddle && shift == 0;
    const bool borders = is_enough && ((keeps_factor_ && is_as_factorised()) || (may_border_ && border_contacts()));
    if (!borders && !factorize(problem, state, &residual, shift, may_be_saddle)) return false;
    find_step(problem, state, residual, step);
    const int most = borders && model_.bending.empty() ? kBorderedContactTurns : kContactTurns;
    if (turn >= most) break;
    are_shafts_revised = revise_shafts(problem, state, step);
    if (!revise_contacts(step, turns) && !are_shafts_revised) break;
  }
  for (std::size_t k = 0; k < open_.size(); ++k) {
    step.contact_forces[k] = open_[k] ? 0 : std::max(0.0, step.contact_forces[k]);
  }
  return true;
}

bool Newton::find_factorised_contacts() {
  const std::vector<ContactPoint> factorised = std::exchange(factorised_contacts_, terms_.contacts);
  const std::vector<char> open = std::exchange(factorised_open_, std::vector<char>(terms_.contacts.size(), 1));
  solved_contacts_.clear();
  bool are_there = true;
  std::size_t k = 0;
  // Both are in the order of their solids and sites.
  for (std::size_t old = 0; old < factorised.size(); ++old) {
    const auto place = [](const ContactPoint& contact) { return std::pair(contact.solid, contact.site); };
    while (k < factorised_contacts_.size() && place(factorised_contacts_[k]) < place(factorised[old])) ++k;
    if (k < factorised_contacts_.size() && place(factorised_contacts_[k]) == place(factorised[old])) {
      factorised_contacts_[k] = factorised[old];
      factorised_open_[k] = open[old];
    } else {
      are_there = are_there && open[old];
    }
  }
  return are_there;
}

bool Newton::is_as_factorised() const {
  return border_.cols() == own_columns_ && open_ == factorised_open_;
}

bool Newton::border_contacts() {
  std::vector<std::size_t> changed;
  double stiffest = 0;  // newton / metre
  for (std::size_t k = 0; k < open_.size(); ++k) {
    if (open_[k] == factorised_open_[k]) continue;
    changed.push_back(k);
    stiffest = std::max(stiffest, factorised_contacts_[k].potential.stiffness);
  }
  if (model_.bending.empty() && changed.size() > kMostBordered) return false;
  if (is_give_lost(border_.leftCols(own_columns_), bordered_.solved_columns().leftCols(own_columns_), stiffest,
                   model_.wall_stiffness)) {
    return false;
  }
  const Eigen::Index columns = own_columns_ + static_cast<Eigen::Index>(changed.size());
  const bool is_open = model_.has_open_chambers();
  border_.conservativeResize(Eigen::NoChange, columns);
  corner_.conservativeResize(columns, columns);
  corner_.rightCols(columns - own_columns_).setZero();
  corner_.bottomRows(columns - own_columns_).setZero();
  int springs = 0;
  for (std::size_t k = 0; k < changed.size(); ++k) {
    const ContactPoint& contact = factorised_contacts_[changed[k]];
    const Eigen::Index column = own_columns_ + static_cast<Eigen::Index>(k);
    border_.col(column).setZero();
    for (int c = 0; c < 3; ++c) {
      border_.col(column).segment<3>(3 * model_.surface[contact.triangle][c]) += contact.gap.gradient.segment<3>(3 * c);
    }
    for (Eigen::Index row = 0; row < border_.rows(); ++row) {
      if (model_.fixed[row]) border_(row, column) = 0;
    }
    // A spring that is added is a constraint that gives way; one that is taken away makes none.
    corner_(column, column) = (open_[changed[k]] ? 1 : -1) / contact.potential.stiffness;
    springs += open_[changed[k]] ? 0 : 1;
  }
  if (is_open) {
    for (Eigen::MatrixXd* side : {&columns_, &rows_}) {
      side->conservativeResize(Eigen::NoChange, columns);
      side->rightCols(columns - own_columns_) = border_.rightCols(columns - own_columns_);
    }
    bordered_.set_unsymmetric(used_factor(), negative_pivots_, border_, columns_, rows_, corner_);
  } else if (model_.bending.empty()) {
    bordered_.set_solved(negative_pivots_, border_, solved_border(changed), corner_);
  } else {
    bordered_.set(used_factor(), negative_pivots_, border_, corner_);
  }
  is_convex_ = bordered_.negative_eigenvalues() == constraints_ + springs;
  return is_convex_;
}

Eigen::MatrixXd Newton::solved_border(const std::vector<std::size_t>& changed) {
  if (solved_contacts_.empty()) solved_own_ = bordered_.solved_columns().leftCols(own_columns_);
  const auto is_solved_already = [&](std::size_t contact) {
    return std::ranges::find(solved_contacts_, contact) != solved_contacts_.end();
  };
  std::vector<Eigen::Index> fresh;  // columns of the border
  for (std::size_t k = 0; k < changed.size(); ++k) {
    if (is_solved_already(changed[k])) continue;
    fresh.push_back(own_columns_ + static_cast<Eigen::Index>(k));
    solved_contacts_.push_back(changed[k]);
  }
  if (!fresh.empty()) {
    Eigen::MatrixXd columns(border_.rows(), static_cast<Eigen::Index>(fresh.size()));
    for (std::size_t k = 0; k < fresh.size(); ++k) columns.col(static_cast<Eigen::Index>(k)) = border_.col(fresh[k]);
    used_factor().solve(columns);
    const Eigen::Index before = solved_own_.cols();
    solved_own_.conservativeResize(border_.rows(), before + columns.cols());
    solved_own_.rightCols(columns.cols()) = columns;
  }
  Eigen::MatrixXd solved(border_.rows(), border_.cols());
  solved.leftCols(own_columns_) = solved_own_.leftCols(own_columns_);
  for (std::size_t k = 0; k < changed.size(); ++k) {
    const auto place = std::ranges::find(solved_contacts_, changed[k]) - solved_contacts_.begin();
    solved.col(own_columns_ + static_cast<Eigen::Index>(k)) = solved_own_.col(own_columns_ + place);
  }
  return solved;
}

void Newton::find_contact_forces(Step& step) const {
  step.contact_forces.clear();
  for (std::size_t k = 0; k < terms_.contacts.size(); ++k) {
    const double opening = gap_change(factorised_contacts_[k], step.position);
    step.contact_forces.push_back(contact_law(terms_.contacts[k]) - terms_.contacts[k].potential.stiffness * opening);
  }
}

bool Newton::revise_contacts(const Step& step, ContactTurns& turns) {
  double push = 0, wrong = 0;  // newton
  double farthest = 0;         // metres, by which a contact that is wrong is overrun, or would be drawn back
  int count = 0;               // of those that are wrong
  for (std::size_t k = 0; k < open_.size(); ++k) {
    const double force = step.contact_forces[k];
    const bool presses = force > 0;
    if (presses == static_cast<bool>(open_[k])) {
      wrong += std::abs(force);
      farthest = std::max(farthest, std::abs(force) / terms_.contacts[k].potential.stiffness);
      ++count;
    } else if (presses) {
      push += force;
    }
  }
  // What the last steps leave wrong no later one mends.
  const bool goes_on = farthest <= step.position.lpNorm<Eigen::Infinity>();
  if (wrong <= kToleratedPull * push && goes_on) return false;
  if (turns.one_by_one) return change_one_contact(step, turns);
  turns.without_gain = count < turns.fewest_wrong ? 0 : turns.without_gain + 1;
  turns.fewest_wrong = std::min(turns.fewest_wrong, count);
  if (turns.may_be_one_by_one && turns.without_gain > 0) {
    turns.one_by_one = true;
    open_ = factorised_open_;
    return true;
  }
  for (std::size_t k = 0; k < open_.size(); ++k) open_[k] = step.contact_forces[k] <= 0;
  return true;
}

bool Newton::change_one_contact(const Step& step, ContactTurns& turns) {
  double part = 1;  // of the way from the forces so far to the step's on which none pulls
  for (std::size_t k = 0; k < open_.size(); ++k) {
    const double from = turns.forces[k], to = step.contact_forces[k];
    if (!open_[k] && to < 0) part = std::min(part, from / (from - to));
  }
  double farthest = 0;  // metres
  std::size_t worst = open_.size();
  for (std::size_t k = 0; k < open_.size(); ++k) {
    const double from = turns.forces[k], to = step.contact_forces[k];
    if (open_[k]) {
      const double way = to / terms_.contacts[k].potential.stiffness;
      if (way > farthest) worst = k;
      farthest = std::max(farthest, way);
      continue;
    }
    turns.forces[k] = std::max(0.0, from + part * (to - from));
    // Those that stop the way let go.
    if (to < 0 && from <= part * (from - to) * (1 + 1e-12)) {
      open_[k] = 1;
      turns.forces[k] = 0;
    }
  }
  if (part < 1) return true;
  if (worst == open_.size()) return false;
  open_[worst] = 0;
  return true;
}

double Newton::gap_change(const ContactPoint& contact, const Eigen::VectorXd& motion) const {
  double change = 0;
  for (int k = 0; k < 3; ++k) {
    change += contact.gap.gradient.segment<3>(3 * k).dot(motion.segment<3>(3 * model_.surface[contact.triangle][k]));
  }
  return change;
}

}  // namespace thinwall
