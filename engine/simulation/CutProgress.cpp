#include "engine/simulation/CutProgress.hpp"

#include <algorithm>

namespace thinwall {
namespace {

/// Part of their forces by which lips are let go in a step without a blade.
constexpr double kIdleRelease = 0.25;

}  // namespace

CutProgress let_go(const CutProgress& progress, const std::optional<BladeInput>& blade, double push) {
  CutProgress after = progress;
  std::erase_if(after.held, [](const HeldLips& lips) { return lips.held == 0; });
  double travel = blade ? progress.progress * blade->travel : 0;
  for (HeldLips& lips : after.held) {
    const double part = std::min(lips.held, blade ? travel / lips.length : kIdleRelease);
    lips.held -= part;
    travel -= part * lips.length;
  }
  after.push = blade ? push : 0;
  after.blade_force.setZero();
  if (blade) after.blade_force = push * blade->direction;
  return after;
}

Eigen::Vector3d mean_pushed(const CutProgress& progress, const Eigen::VectorXd& values) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const PushedVertex& pushed : progress.pushed) sum += pushed.share * values.segment<3>(3 * pushed.vertex);
  return sum;
}

Eigen::VectorXd force_at_lips(const CutProgress& progress, Eigen::Index unknowns) {
  if (progress.held.empty() && progress.blade_force.isZero()) return {};
  Eigen::VectorXd force = Eigen::VectorXd::Zero(unknowns);
  for (const HeldLips& lips : progress.held) {
    for (const HeldForce& one : lips.forces) force.segment<3>(3 * one.vertex) += lips.held * one.force;
    for (const HeldTurn& one : lips.turns) force[one.unknown] += lips.held * one.force;
  }
  for (const PushedVertex& pushed : progress.pushed) {
    force.segment<3>(3 * pushed.vertex) += pushed.share * progress.blade_force;
  }
  return force;
}

}  // namespace thinwall
