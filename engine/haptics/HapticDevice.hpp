#pragma once

#include <Eigen/Core>
#include <optional>

#include "engine/tool/Tool.hpp"

namespace thinwall {

/// Metres from the scene's origin that a hand does not reach: what says so is no pose of one.
constexpr double kFarthestHand = 10;

/// What a hand holds: something that tells where the tool is and is told what it feels. Both calls come from the
/// real-time thread once a tick and must not wait.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  /// Where the tool is `time` seconds after the beginning; nothing when the motion has ended.
  virtual std::optional<ToolPose> pose_at(double time) = 0;

  /// `force`: newton, what the tissue does to the tool.
  virtual void feel(double time, const Eigen::Vector3d& force) = 0;

  /// The loop has ended, however it did: the hand is to feel nothing any more.
  virtual void let_go() {}
};

}  // namespace thinwall
