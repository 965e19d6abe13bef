#pragma once

#include <vector>

#include "engine/haptics/HapticDevice.hpp"

namespace thinwall {

/// A pose at a moment.
struct TimedPose {
  double time = 0;  // seconds
  ToolPose pose;
};

/// A motion that was recorded or scripted, played again: straight between its moments.
class Trajectory final : public HapticDevice {
 public:
  /// `moments` in order of time. Asserts that there is one.
  explicit Trajectory(std::vector<TimedPose> moments);

  std::optional<ToolPose> pose_at(double time) override;
  void feel(double, const Eigen::Vector3d&) override {}

  double end() const { return moments_.back().time; }  // seconds

 private:
  std::vector<TimedPose> moments_;
};

}  // namespace thinwall
