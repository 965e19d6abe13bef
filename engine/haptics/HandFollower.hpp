#pragma once

#include <Eigen/Core>
#include <atomic>
#include <exception>
#include <functional>
#include <thread>

#include "engine/haptics/TripleBuffer.hpp"
#include "engine/tool/Tool.hpp"

namespace thinwall {

/// Where the hand was last.
struct HandState {
  double time = 0;  // seconds since the beginning
  ToolPose pose;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // metres / second
};

/// What the work beside a haptic loop took.
struct RefreshFigures {
  long solutions = 0;
  double longest = 0;  // seconds
  double total = 0;    // seconds

  void note(double duration);
};

/// A thread that does its work for where the hand was last, again and again. It never waits for the hand, nor the hand
/// for it.
class HandFollower {
 public:
  using Work = std::function<void(const HandState&)>;

  explicit HandFollower(Work work);
  ~HandFollower() { stop(); }
  HandFollower(const HandFollower&) = delete;
  HandFollower& operator=(const HandFollower&) = delete;

  void tell(const HandState& hand);
  bool has_failed() const { return has_failed_.load(std::memory_order_acquire); }

  /// Waits for the work under way, and throws what it threw.
  void finish();

 private:
  void stop();
  void follow();

  Work work_;
  TripleBuffer<HandState> hands_;
  std::atomic<bool> ends_ = false;
  std::atomic<bool> has_failed_ = false;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace thinwall
