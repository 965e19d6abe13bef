#include "engine/haptics/PassivityGuard.hpp"

#include <algorithm>

namespace thinwall {

Eigen::Vector3d PassivityGuard::guard(const Eigen::Vector3d& wanted, const Eigen::Vector3d& motion, double duration) {
  absorbed_ -= given_.dot(motion);
  given_ = wanted;
  const Eigen::Vector3d velocity = motion / duration;
  const double speed = velocity.squaredNorm(), excess = -(absorbed_ + options_.allowance);
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
