#include "engine/simulation/CutProgress.hpp"

#include <algorithm>

namespace thinwall {
namespace {

/// Part of their forces by which lips are let go in a step without a blade.
constexpr double kIdleRelease = 0.25;

}  // namespace

CutProgress let_go(const CutProgress& progress, const std::optional<BladeInput>& blade) {
  CutProgress after = progress;
  std::erase_if(after.held, [](const HeldLips& lips) { return lips.held == 0; });
  double travel = blade ? progress.progress * blade->travel : 0;
  for (HeldLips& lips : after.held) {
    const double part = std::min(lips.held, blade ? travel / lips.length : kIdleRelease);
    lips.held -= part;
    travel -= part * lips.length;
  }
  after.push = blade && blade->travel > 0 ? progress.resistance : 0;
  return after;
}

Eigen::VectorXd force_at_lips(const CutProgress& progress, Eigen::Index unknowns) {
  if (progress.held.empty()) return {};
  Eigen::VectorXd force = Eigen::VectorXd::Zero(unknowns);
  for (const HeldLips& lips : progress.held) {
    for (const HeldForce& one : lips.forces) force.segment<3>(3 * one.vertex) += lips.held * one.force;
    for (const HeldTurn& one : lips.turns) force[one.unknown] += lips.held * one.force;
  }
  return force;
}

}  // namespace thinwall
