#include "engine/equilibrium/PatchEnergy.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/equilibrium/LeastMotion.hpp"
#include "engine/equilibrium/WallTriangle.hpp"

namespace thinwall {

PatchEnergy::PatchEnergy(const BodyModel& model, const EquilibriumProblem& problem, const WallPatch& patch,
                         std::vector<NearPair> folds, double fold_pressure, const Eigen::VectorXd& position,
                         const Eigen::VectorXd& force)
    : model_(model),
      problem_(problem),
      patch_(patch),
      folds_(std::move(folds)),
      fold_pressure_(fold_pressure),
      start_(position(patch.unknowns)),
      dead_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(patch.unknowns.size()))) {
  evaluate(position, true);
  dead_ = force(patch.unknowns) - gradient_;
  gradient_ += dead_;
}

void PatchEnergy::evaluate(const Eigen::VectorXd& position, bool with_hessian) {
  const auto size = static_cast<Eigen::Index>(patch_.unknowns.size());
  value_ = dead_.dot(position(patch_.unknowns) - start_);
  gradient_ = dead_;
  if (with_hessian) hessian_.setZero(size, size);
  add_wall(position, with_hessian);
  add_folds(position, with_hessian);
  add_inertia(position, with_hessian);
  if (problem_.seeks_least_motion()) add_slack(position, with_hessian);
}

/// Of the two places of an entry off the diagonal the one below it is kept.
void PatchEnergy::add_to_hessian(int row, int column, double value) {
  const int one = patch_.number[row], other = patch_.number[column];
  if (one >= 0 && other >= 0) hessian_(std::max(one, other), std::min(one, other)) += value;
}

void PatchEnergy::add_wall(const Eigen::VectorXd& position, bool with_hessian) {
  const int triangles = static_cast<int>(patch_.triangles.size());
  MembraneLanes lanes;
  for (int first = 0; first < triangles; first += kLanes) {
    std::array<MembraneTriangle, kLanes> members;
    const int count = std::min(kLanes, triangles - first);
    for (int k = 0; k < count; ++k) {
      members[k] = wall_triangle(model_, problem_.memory, position, patch_.triangles[first + k]);
    }
    membrane_lanes({members.data(), static_cast<std::size_t>(count)}, with_hessian, lanes);
    for (int k = 0; k < count; ++k) {
      const Eigen::Vector3i& corners = model_.surface[patch_.triangles[first + k]];
      value_ += lanes.energy[k];
      for (int i = 0; i < 9; ++i) {
        const int number = patch_.number[3 * corners[i / 3] + i % 3];
        if (number >= 0) gradient_[number] += lanes.gradient[i][k];
      }
      if (!with_hessian) continue;
      for (std::size_t b = 0; b < kBlockCorners.size(); ++b) {
        const auto& [one, other] = kBlockCorners[b];
        for (int i = 0; i < 9; ++i) {
          const int row = i % 3, column = i / 3;
          if (one == other && row < column) continue;
          add_to_hessian(3 * corners[one] + row, 3 * corners[other] + column, lanes.hessian[b][i][k]);
        }
      }
    }
  }
}

void PatchEnergy::add_slack(const Eigen::VectorXd& position, bool with_hessian) {
  for (const int triangle : patch_.triangles) {
    const LeastMotionTerms terms = least_motion_terms(model_, problem_.least_motion, position, triangle);
    std::array<int, 9> unknowns;
    for (int i = 0; i < 9; ++i) unknowns[i] = 3 * model_.surface[triangle][i / 3] + i % 3;
    value_ += terms.energy;
    for (int i = 0; i < 9; ++i) {
      const int number = patch_.number[unknowns[i]];
      if (number >= 0) gradient_[number] += terms.gradient[i];
    }
    if (!with_hessian) continue;
    for (int i = 0; i < 9; ++i) {
      for (int j = 0; j <= i; ++j) add_to_hessian(unknowns[i], unknowns[j], terms.hessian(i, j));
    }
  }
}

void PatchEnergy::add_folds(const Eigen::VectorXd& position, bool with_hessian) {
  for (const NearPair& near : folds_) {
    const auto pair = fold_of(near, position, fold_pressure_);
    if (!pair) continue;
    const FoldTerms terms = pair->terms();
    std::array<int, 12> unknowns;
    for (int i = 0; i < 12; ++i) unknowns[i] = 3 * near.vertices[i / 3] + i % 3;
    value_ += terms.energy;
    for (int i = 0; i < 12; ++i) {
      const int number = patch_.number[unknowns[i]];
      if (number >= 0) gradient_[number] += terms.gradient[i];
    }
    if (!with_hessian) continue;
    const Eigen::Matrix<double, 12, 12> hessian = pair->hessian();
    for (int i = 0; i < 12; ++i) {
      for (int j = 0; j <= i; ++j) add_to_hessian(unknowns[i], unknowns[j], hessian(i, j));
    }
  }
}

void PatchEnergy::add_inertia(const Eigen::VectorXd& position, bool with_hessian) {
  if (problem_.inertia == 0) return;
  for (std::size_t k = 0; k < patch_.unknowns.size(); ++k) {
    const int unknown = patch_.unknowns[k];
    const auto number = static_cast<Eigen::Index>(k);
    const double off = position[unknown] - problem_.inertia_target[unknown];
    const double spring = problem_.inertia * model_.mass[unknown];
    value_ += 0.5 * spring * off * off;
    gradient_[number] += spring * off;
    if (with_hessian) hessian_(number, number) += spring;
  }
}

}  // namespace thinwall
