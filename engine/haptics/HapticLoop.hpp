#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "engine/haptics/CorrectionRefresh.hpp"
#include "engine/haptics/ForceBlend.hpp"
#include "engine/haptics/HapticDevice.hpp"
#include "engine/haptics/ModelRefresh.hpp"
#include "engine/haptics/PassivityGuard.hpp"

namespace thinwall {

struct HapticLoopOptions {
  double period = 1e-3;    // seconds
  double duration = 0;     // seconds, after which the loop ends if the device has not ended it before
  double blending = 4e-3;  // seconds
  PassivityOptions passivity = {};
  bool real_time = true;                      // whether to ask the system for real-time scheduling
  std::function<bool()> is_interrupted = {};  // asked once a tick; must not wait
};

/// A tick of the loop. Times in seconds.
struct HapticTick {
  double time = 0;      // since the beginning, for which it was planned
  double woken = 0;     // by which it woke late
  double computed = 0;  // from waking until the force was given
  double age = 0;       // of the hand's pose that the model in use was asked for
  bool missed = false;  // whether the next one was due before it had ended
  bool fresh = false;   // whether a newer model took over
  ToolPose pose;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // newton, given to the hand

  double latency() const { return woken + computed; }
};

struct HapticRecord {
  std::vector<HapticTick> ticks;
  long skipped = 0;  // ticks that were left out because one before took longer than a period
  bool was_real_time = false;
  double damped = 0;  // joule, asked of the passivity guard
  long braked = 0;    // ticks in which it braked
  long yielded = 0;   // ticks in which it gave less than the force wanted
  bool interrupted = false;
  bool solver_failed = false;
};

/// What gives the hand its force in a tick: from the pose now and the time.
class ForceSource {
 public:
  virtual ~ForceSource() = default;
  /// Called in the real-time thread before the first tick, for what takes long when it is done first.
  virtual void begin() {}
  /// Called in the real-time thread once a tick; `tick` has time and pose. Fills what it knows of age and freshness.
  virtual Eigen::Vector3d force(HapticTick& tick, const Eigen::Vector3d& velocity) = 0;
  /// Whether it can give forces no more.
  virtual bool has_failed() const { return false; }
};

/// Gives the force of the newest local model, blended where one takes over from another.
class LocalForce final : public ForceSource {
 public:
  LocalForce(ModelRefresh& refresh, double blending) : refresh_(refresh), blend_(blending) {}
  Eigen::Vector3d force(HapticTick& tick, const Eigen::Vector3d& velocity) override;
  bool has_failed() const override { return refresh_.has_failed(); }

 private:
  ModelRefresh& refresh_;
  ForceBlend blend_;
};

/// Gives the force of the local model of a coarse body, corrected by what a fine body gives beyond it.
class CorrectedForce final : public ForceSource {
 public:
  /// `blending`: seconds in which a newer correction takes over.
  CorrectedForce(LocalForce& coarse, CorrectionRefresh& refresh, double blending)
      : coarse_(coarse), refresh_(refresh), blending_(blending), blend_(blending) {}
  Eigen::Vector3d force(HapticTick& tick, const Eigen::Vector3d& velocity) override;
  bool has_failed() const override { return coarse_.has_failed() || refresh_.has_failed(); }

 private:
  LocalForce& coarse_;
  CorrectionRefresh& refresh_;
  double blending_;     // seconds
  double blended_ = 0;  // seconds, when the correction in use has taken over
  ForceBlend blend_;
};

/// Solves fully in each tick: for small bodies.
class FullForce final : public ForceSource {
 public:
  /// `most_way`: metres that the tool goes in a tick. A hand that is set elsewhere it follows at that rate: a way of
  /// any length would take a time of any length.
  /// `warm_up`: see `begin`.
  FullForce(FullSolver solver, double most_way, std::function<void()> warm_up = {})
      : solver_(std::move(solver)), most_way_(most_way), warm_up_(std::move(warm_up)) {}
  void begin() override {
    if (warm_up_) warm_up_();
  }
  Eigen::Vector3d force(HapticTick& tick, const Eigen::Vector3d& velocity) override;

 private:
  FullSolver solver_;
  double most_way_;  // metres
  std::function<void()> warm_up_;
  std::optional<ToolPose> reached_;  // in the last tick
};

/// No force at all, and no work: what the loop itself costs.
class NoForce final : public ForceSource {
 public:
  Eigen::Vector3d force(HapticTick&, const Eigen::Vector3d&) override { return Eigen::Vector3d::Zero(); }
};

/// Runs in a thread of its own, until the device or the duration ends it; what a source throws goes through.
HapticRecord run_haptic_loop(HapticDevice& device, ForceSource& source, const HapticLoopOptions& options);

}  // namespace thinwall
