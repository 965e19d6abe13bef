#pragma once

#include <functional>
#include <optional>

#include "engine/haptics/HandFollower.hpp"
#include "engine/haptics/TripleBuffer.hpp"

namespace thinwall {

/// What a fine body gives a tool beyond what a coarse body of the same organ gives it at the same pose. Both follow the
/// tool in nearly the same course, so what they differ by changes little while the tool goes on: the coarse one, which
/// is solved far more often, tells the course, and the fine one how large the force is.
struct ForceCorrection {
  Eigen::Vector3d difference = Eigen::Vector3d::Zero();  // newton, of the fine force less the coarse one
  double coarse = 0;                                     // newton, size of the coarse force there

  /// Newton, to be added to a coarse force: it fades with that, so that a tool that has left feels nothing.
  Eigen::Vector3d of(const Eigen::Vector3d& coarse_force) const;
};

/// Forces of both bodies at a pose, newton.
struct ForcePair {
  Eigen::Vector3d fine = Eigen::Vector3d::Zero();
  Eigen::Vector3d coarse = Eigen::Vector3d::Zero();
};

/// Brings both bodies to where the hand is at that time. Time goes on from call to call.
using PairSolver = std::function<ForcePair(double time, const ToolPose& pose)>;

/// The slowest side of a haptic loop: solves both bodies for where the hand is, again and again.
class CorrectionRefresh {
 public:
  /// `most_way`: metres that the tool goes in a solution.
  CorrectionRefresh(PairSolver solver, const HandState& begin, double most_way);

  // Of the fast side.
  void tell(const HandState& hand) { follower_->tell(hand); }
  bool has_newer() const { return corrections_.has_fresh(); }
  bool take_newer() { return corrections_.take(); }
  const ForceCorrection& correction() const { return corrections_.front(); }
  bool has_failed() const { return follower_->has_failed(); }

  /// Waits for the solution under way, and throws what a solution threw.
  void finish() { follower_->finish(); }
  /// After `finish`.
  const RefreshFigures& figures() const { return figures_; }

 private:
  void refresh(const HandState& hand);

  PairSolver solver_;
  double most_way_;
  TripleBuffer<ForceCorrection> corrections_;
  RefreshFigures figures_;
  ToolPose reached_;                      // of the last solution
  std::optional<HandFollower> follower_;  // last, so that it ends first
};

}  // namespace thinwall
