#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/simulation/Body.hpp"

namespace thinwall {
namespace {

/// Multiple of the last step that is extrapolated at most.
constexpr double kFarthest = 2;

/// Cosine of the angle by which tools may turn aside and still go on as they did.
constexpr double kStraight = 0.7;

/// Parts of its last way by which a wall with inertia may go on, tried as long as they miss less. Lips that have just
/// been cut, and a wall that a tool has just met or left, do not go on as they did.
constexpr double kGoingOn[] = {1, 0.5, 0};

/// Part of its mean velocity in the last step that may be other than the velocity before, and the wall still goes on as
/// it did: to try what else it might do takes up to a third as long as an iteration.
constexpr double kSteady = 0.25;

/// By which part of their last way tools go on; nothing where they turn aside.
double going_on(std::span<const ToolPose> begin, std::span<const ToolPose> end,
                const std::vector<Eigen::Vector3d>& last) {
  double along = 0, squares = 0, own = 0;  // metres^2
  for (std::size_t k = 0; k < last.size(); ++k) {
    along += (end[k].tip - begin[k].tip).dot(last[k]);
    squares += last[k].squaredNorm();
    own += (end[k].tip - begin[k].tip).squaredNorm();
  }
  return std::abs(along) > kStraight * std::sqrt(squares * own) ? std::clamp(along / squares, -1.0, kFarthest) : 0;
}

}  // namespace

void Body::begin_as_moving(double duration, EquilibriumProblem& problem, EquilibriumState& trial) const {
  const Eigen::VectorXd start = trial.position;
  const auto part_of_way = [&](const Eigen::VectorXd& velocity) {
    const Eigen::VectorXd motion = duration * velocity;
    return Eigen::VectorXd(newton_->safe_fraction(start, motion) * motion);
  };
  Eigen::VectorXd mean = state_.velocity;
  if (state_.previous_step > 0) mean = (start - state_.previous_position) / state_.previous_step;
  const bool is_steady = state_.previous_step == 0 || (mean - state_.previous_velocity).norm() <= kSteady * mean.norm();
  const Eigen::VectorXd motion = part_of_way(is_steady ? state_.velocity : mean);
  if (is_steady) {
    trial.position += motion;
    return;
  }
  EquilibriumState tried = trial;
  double least = std::numeric_limits<double>::infinity();
  for (const double part : kGoingOn) {
    tried.position = start + part * motion;
    const double missed = newton_->missed(problem, tried);
    if (!(missed < least)) break;
    least = missed;
    trial.position = tried.position;
  }
}

void Body::note_last_step(std::span<const ToolPose> begin, std::span<const ToolPose> end) {
  // The memory of the step before is used again.
  if (!last_step_) last_step_.emplace();
  last_step_->way.clear();
  for (std::size_t k = 0; k < begin.size(); ++k) last_step_->way.push_back(end[k].tip - begin[k].tip);
  last_step_->before = state_.equilibrium;
  last_step_->solid_forces = state_.solid_forces;
}

bool Body::begin_as_extrapolated(std::span<const ToolPose> begin, std::span<const ToolPose> end,
                                 EquilibriumProblem& problem, EquilibriumState& trial) const {
  const LastStep& last = *last_step_;
  const EquilibriumState& now = state_.equilibrium;
  const double part = going_on(begin, end, last.way);
  const bool is_same_wall =
      last.before.position.size() == now.position.size() && last.before.pressure.size() == now.pressure.size();
  if (has_inertia() || part == 0 || !is_same_wall) return false;
  trial.position = now.position + part * (now.position - last.before.position);
  trial.pressure = now.pressure + part * (now.pressure - last.before.pressure);
  for (std::size_t k = 0; k < problem.solids.size(); ++k) {
    std::vector<double>& forces = problem.solids[k].forces;
    const std::vector<double>& before = last.solid_forces[k];
    for (std::size_t s = 0; s < forces.size(); ++s) {
      // What has just come to press says nothing of how it goes on.
      if (forces[s] > 0 && before[s] > 0) forces[s] = std::max(0.0, forces[s] + part * (forces[s] - before[s]));
    }
  }
  return true;
}

}  // namespace thinwall
