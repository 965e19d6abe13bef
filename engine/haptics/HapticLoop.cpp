#include "engine/haptics/HapticLoop.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <thread>

#include "engine/haptics/RealTimeThread.hpp"
#include "engine/tool/PoseBetween.hpp"

namespace thinwall {
namespace {

/// A tool that goes farther in a tick was set elsewhere: metres / second.
constexpr double kFastestHand = 2;

/// Memory for more ticks than this is not taken beforehand, seconds.
constexpr double kLongestReserve = 600;

/// How the tool has moved from one tick to the next.
struct Movement {
  Eigen::Vector3d way = Eigen::Vector3d::Zero();  // metres; none of a tool that was set elsewhere
  double duration = 0;                            // seconds: more than a period where ticks were left out
};

class MovementWatch {
 public:
  explicit MovementWatch(double period) : period_(period) {}

  Movement to(double time, const Eigen::Vector3d& tip) {
    Movement movement{.duration = has_begun_ ? time - time_ : period_};
    const Eigen::Vector3d way = tip - tip_;
    if (has_begun_ && way.norm() <= kFastestHand * movement.duration) movement.way = way;
    has_begun_ = true;
    tip_ = tip;
    time_ = time;
    return movement;
  }

 private:
  double period_;    // seconds
  double time_ = 0;  // seconds
  bool has_begun_ = false;
  Eigen::Vector3d tip_ = Eigen::Vector3d::Zero();  // metres
};

void run(HapticDevice& device, ForceSource& source, const HapticLoopOptions& options, HapticRecord& record) {
  record.was_real_time = options.real_time && ask_for_real_time();
  source.begin();
  PassivityGuard guard(options.passivity);
  MovementWatch watch(options.period);
  const double begin = loop_clock() + options.period;
  for (long k = 0;; ++k) {
    HapticTick tick{.time = static_cast<double>(k) * options.period, .pose = {}};
    if (tick.time > options.duration) break;
    sleep_until(begin + tick.time);
    const double woken = loop_clock();
    tick.woken = woken - begin - tick.time;
    const std::optional<ToolPose> pose = device.pose_at(tick.time);
    if (!pose) break;
    tick.pose = *pose;
    const Movement movement = watch.to(tick.time, tick.pose.tip);
    const Eigen::Vector3d wanted = source.force(tick, movement.way / movement.duration);
    tick.force = guard.guard(wanted, movement.way, movement.duration);
    device.feel(tick.time, tick.force);
    const double done = loop_clock();
    tick.computed = done - woken;
    tick.missed = done > begin + tick.time + options.period;
    record.ticks.push_back(tick);
    if (tick.missed) {
      const long late = std::lround(std::floor((done - begin) / options.period)) - k - 1;
      record.skipped += std::max(0L, late);
      k += std::max(0L, late);
    }
    record.solver_failed = source.has_failed();
    record.interrupted = options.is_interrupted && options.is_interrupted();
    if (record.solver_failed || record.interrupted) break;
  }
  record.damped = guard.dissipated();
  record.braked = guard.braked();
  record.yielded = guard.yielded();
}

}  // namespace

Eigen::Vector3d LocalForce::force(HapticTick& tick, const Eigen::Vector3d& velocity) {
  refresh_.tell({.time = tick.time, .pose = tick.pose, .velocity = velocity});
  if (refresh_.has_newer()) {
    const Eigen::Vector3d given = blend_.force(tick.time, refresh_.model().force_at(tick.pose));
    refresh_.take_newer();
    tick.fresh = true;
    blend_.take_over(tick.time, given, refresh_.model().force_at(tick.pose));
  }
  tick.age = tick.time - refresh_.model().time;
  return blend_.force(tick.time, refresh_.model().force_at(tick.pose));
}

Eigen::Vector3d CorrectedForce::force(HapticTick& tick, const Eigen::Vector3d& velocity) {
  const Eigen::Vector3d coarse = coarse_.force(tick, velocity);
  refresh_.tell({.time = tick.time, .pose = tick.pose, .velocity = velocity});
  // One that takes over before the last has done so would leave it undone.
  if (refresh_.has_newer() && tick.time >= blended_) {
    const Eigen::Vector3d given = blend_.force(tick.time, refresh_.correction().of(coarse));
    refresh_.take_newer();
    blended_ = tick.time + blending_;
    blend_.take_over(tick.time, given, refresh_.correction().of(coarse));
  }
  return coarse + blend_.force(tick.time, refresh_.correction().of(coarse));
}

Eigen::Vector3d FullForce::force(HapticTick& tick, const Eigen::Vector3d&) {
  tick.fresh = true;
  ToolPose pose = tick.pose;
  const double way = reached_ ? (pose.tip - reached_->tip).norm() : 0;
  if (way > most_way_) pose = between(*reached_, pose, most_way_ / way);
  reached_ = pose;
  return solver_(tick.time, pose).response.force;
}

HapticRecord run_haptic_loop(HapticDevice& device, ForceSource& source, const HapticLoopOptions& options) {
  HapticRecord record;
  record.ticks.reserve(static_cast<std::size_t>(std::min(options.duration, kLongestReserve) / options.period) + 2);
  std::exception_ptr failure;
  std::thread thread([&] {
    try {
      run(device, source, options, record);
    } catch (...) {
      failure = std::current_exception();
    }
  });
  thread.join();
  device.let_go();
  if (failure) std::rethrow_exception(failure);
  return record;
}

}  // namespace thinwall
