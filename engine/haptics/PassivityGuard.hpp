#pragma once

#include <Eigen/Core>

namespace thinwall {

struct PassivityOptions {
  double allowance = 2e-4;    // joule that may be given out before it is damped: what holding a force for a tick makes
  double most_damping = 5;    // newton second / metre
  double onset = 0.02;        // seconds in which the damping may rise from nothing to its most, so that no force jumps
  double most_excess = 1e-3;  // joule beyond the allowance from which on braking is not enough, and the force yields
  double yielding = 5e-3;     // seconds in which the force yields at that excess, the sooner the larger it is
  double recovery = 2;        // seconds in which it comes back: sooner a hand would be driven in turns
  double pardon = 2e-4;       // watt of what was given out that is forgotten, less than any hand dissipates
  double way_before = 0;      // metres that a tool which begins in the wall was pressed in before, at most
};

/// Keeps the hand from being driven by what delays and holds make up: adds up the work that the tissue does on the tool
/// and, where it gives more than it was given, brakes the tool by as much as takes that back, within a limit (energy
/// observer and passivity controller: Hannaford and Ryu 2002, series form). Braking alone does not hold a hand that a
/// stiff wall answers late: there the whole force yields, and comes back slowly, to no more than the hand can stand.
class PassivityGuard {
 public:
  explicit PassivityGuard(const PassivityOptions& options) : options_(options) {}

  /// Once a tick. `motion`: metres, of the tip since the last tick, on which the force given then did work; `duration`:
  /// seconds. Gives what the hand may be given for the force wanted, newton.
  Eigen::Vector3d guard(const Eigen::Vector3d& wanted, const Eigen::Vector3d& motion, double duration);

  double dissipated() const { return dissipated_; }  // joule, asked of the guard so far
  long braked() const { return braked_; }            // ticks in which it braked
  long yielded() const { return yielded_; }          // ticks in which the force was less than wanted

 private:
  /// `excess`: joule, given out beyond the allowance; `drives`: whether the force wanted would give out more.
  void update_share(double excess, bool drives, double duration);

  PassivityOptions options_;
  bool has_begun_ = false;
  Eigen::Vector3d given_ = Eigen::Vector3d::Zero();
  double absorbed_ = 0;    // joule, that the hand has put in so far, less what it was given
  double dissipated_ = 0;  // joule
  double damping_ = 0;     // newton second / metre
  double share_ = 1;       // of the force wanted, that is given
  long braked_ = 0, yielded_ = 0;
};

}  // namespace thinwall
