#include "engine/haptics/CorrectionRefresh.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/tool/PoseBetween.hpp"

namespace thinwall {

Eigen::Vector3d ForceCorrection::of(const Eigen::Vector3d& coarse_force) const {
  return coarse > 0 ? Eigen::Vector3d(std::min(1.0, coarse_force.norm() / coarse) * difference)
                    : Eigen::Vector3d::Zero();
}

CorrectionRefresh::CorrectionRefresh(PairSolver solver, const HandState& begin, double most_way)
    : solver_(std::move(solver)), most_way_(most_way), reached_(begin.pose) {
  refresh(begin);
  corrections_.take();
  follower_.emplace([this](const HandState& hand) { refresh(hand); });
}

void CorrectionRefresh::refresh(const HandState& hand) {
  const auto begin = std::chrono::steady_clock::now();
  const double way = (hand.pose.tip - reached_.tip).norm();
  reached_ = way > most_way_ ? between(reached_, hand.pose, most_way_ / way) : hand.pose;
  const ForcePair forces = solver_(hand.time, reached_);
  corrections_.back() = {.difference = forces.fine - forces.coarse, .coarse = forces.coarse.norm()};
  corrections_.publish();
  figures_.note(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
}

}  // namespace thinwall
