#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace thinwall {

/// Lets a force go over from one model to the next without a jump: what the models differ by where one takes over from
/// the other dies away by 1 - 3 s^2 + 2 s^3, s from 0 to 1 over the blending time.
class ForceBlend {
 public:
  /// `duration`: seconds.
  explicit ForceBlend(double duration) : duration_(duration) {}

  /// At the moment when another model takes over: what the hand was given there, and what the new model gives, newton.
  void take_over(double time, const Eigen::Vector3d& given, const Eigen::Vector3d& of_model) {
    begin_ = time;
    difference_ = given - of_model;
  }

  /// The force for the hand, from that of the model in use.
  Eigen::Vector3d force(double time, const Eigen::Vector3d& of_model) const {
    const double s = duration_ > 0 ? std::clamp((time - begin_) / duration_, 0.0, 1.0) : 1;
    return of_model + (1 - s * s * (3 - 2 * s)) * difference_;
  }

 private:
  double duration_;
  double begin_ = 0;
  Eigen::Vector3d difference_ = Eigen::Vector3d::Zero();
};

}  // namespace thinwall
