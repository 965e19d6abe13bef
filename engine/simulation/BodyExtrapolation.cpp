#include <algorithm>
#include <cmath>

#include "engine/simulation/Body.hpp"

namespace thinwall {
namespace {

/// Multiple of the last step that is extrapolated at most.
constexpr double kFarthest = 2;

/// Cosine of the angle by which tools may turn aside and still go on as they did.
constexpr double kStraight = 0.7;

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
