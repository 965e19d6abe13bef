#include "engine/simulation/CutProgress.hpp"

#include <algorithm>
#include <cassert>

namespace thinwall {
namespace {

/// Part of their forces by which lips are let go in a step where no blade leads.
constexpr double kIdleRelease = 0.25;

/// Part of what a cut is worth that the forces at its lips may do on the wall.
constexpr double kMostDriven = 0.2;

}  // namespace

CutProgress let_go(const CutProgress& progress, const std::optional<BladeInput>& blade) {
  CutProgress after = progress;
  std::erase_if(after.held, [](const HeldLips& lips) { return lips.held == 0; });
  double travel = blade ? progress.progress * blade->travel : 0;
  for (HeldLips& lips : after.held) {
    const bool follows = blade && !lips.runs && !lips.drives;
    // Half of what drives the wall before a step counts as done on it: where that is much the step is divided.
    const double idle = (lips.drives ? 1 : kIdleRelease) * progress.division;
    const double part = std::min(lips.held, follows ? travel / lips.length : idle);
    lips.held -= part;
    if (follows) travel -= part * lips.length;
  }
  after.push = blade && blade->travel > 0 ? progress.resistance : 0;
  return after;
}

void note_work(const Eigen::VectorXd& motion, CutProgress& cut) {
  for (HeldLips& lips : cut.held) {
    for (const HeldForce& one : lips.forces) lips.work += lips.held * one.force.dot(motion.segment<3>(3 * one.vertex));
    for (const HeldTurn& one : lips.turns) lips.work += lips.held * one.force * motion[one.unknown];
    lips.drives = lips.drives || lips.work > kMostDriven * lips.worth;
  }
}

bool mark_driving(const CutProgress& after, CutProgress& before) {
  bool any = false;
  auto now = after.held.begin();
  for (HeldLips& lips : before.held) {
    // Those that nothing holds any more the step has left out.
    if (lips.held == 0) continue;
    assert(now != after.held.end());
    any = any || (now->drives && !lips.drives);
    lips.drives = (now++)->drives;
  }
  return any;
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

double unpaid(const CutProgress& cut) {
  double to_come = 0;
  for (const HeldLips& lips : cut.held) to_come += lips.pays ? lips.held * lips.length * std::max(0.0, cut.given) : 0;
  return cut.due - to_come;
}

double length_of(std::span<const Lips> cut, const Eigen::VectorXd& position) {
  double length = 0;
  for (const Lips& lips : cut) {
    for (std::size_t k = 1; k < lips.left.size(); ++k) {
      length += (position.segment<3>(3 * lips.left[k]) - position.segment<3>(3 * lips.left[k - 1])).norm();
    }
  }
  return length;
}

}  // namespace thinwall
