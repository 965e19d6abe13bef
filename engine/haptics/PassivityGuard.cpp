#include "engine/haptics/PassivityGuard.hpp"

#include <algorithm>

namespace thinwall {

void PassivityGuard::update_share(double excess, bool drives, double duration) {
  if (excess > options_.most_excess && drives) {
    share_ = std::max(0.0, share_ - duration / options_.yielding * excess / options_.most_excess);
  } else if (excess <= 0) {
    share_ = std::min(1.0, share_ + duration / options_.recovery);
  }
  if (share_ < 1) ++yielded_;
}

Eigen::Vector3d PassivityGuard::guard(const Eigen::Vector3d& wanted, const Eigen::Vector3d& motion, double duration) {
  if (!has_begun_) absorbed_ = wanted.norm() * options_.way_before;
  has_begun_ = true;
  absorbed_ -= given_.dot(motion);
  const Eigen::Vector3d velocity = motion / duration;
  const double speed = velocity.squaredNorm(), excess = -(absorbed_ + options_.allowance);
  if (excess > 0) absorbed_ += std::min(excess, options_.pardon * duration);
  update_share(excess, wanted.dot(motion) > 0, duration);
  given_ = share_ * wanted;
  // A tool that goes on as it does gives back the excess within a tick.
  const double wanted_damping = excess > 0 && speed > 0 ? excess / (speed * duration) : 0;
  const double change = options_.most_damping * duration / options_.onset;
  damping_ = std::clamp(std::min(wanted_damping, options_.most_damping), damping_ - change, damping_ + change);
  if (damping_ <= 0) return given_;
  given_ -= damping_ * velocity;
  dissipated_ += damping_ * speed * duration;
  ++braked_;
  return given_;
}

}  // namespace thinwall
