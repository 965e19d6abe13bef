#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/haptics/HapticLoop.hpp"
#include "studio/haptics/PeerDevice.hpp"

namespace thinwall {

/// Percentiles of a time, seconds: the smallest that so many of all do not exceed.
struct Percentiles {
  double p50 = 0, p99 = 0, p999 = 0, largest = 0;
};
Percentiles percentiles_of(std::vector<double> values);

/// A force that a tool was given or should have been.
struct TimedForce {
  double time = 0;                                  // seconds
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // newton
};

/// What was given to the hand, held against the full solution.
struct ForceError {
  double largest_force = 0;     // newton, of the full solution
  double largest = 0;           // newton
  double root_mean_square = 0;  // newton
  double at = 0;                // seconds, of the largest
  long samples = 0;

  double largest_part() const { return largest_force > 0 ? largest / largest_force : 0; }
  double mean_part() const { return largest_force > 0 ? root_mean_square / largest_force : 0; }
};

/// At each moment of the full solution, the force that the hand had been given last.
ForceError force_error(const std::vector<HapticTick>& ticks, const std::vector<TimedForce>& full);

/// Largest change of force from a tick to the next, newton.
double largest_jump(const std::vector<HapticTick>& ticks);
/// The same of the full solution, straight between its moments.
double largest_change(const std::vector<TimedForce>& full, double period);

/// All that `thinwall haptic` tells.
struct HapticReport {
  std::string scenario = {}, tool = {}, forces = {};  // forces: "local" or "full"
  int triangles = 0;                                  // of all bodies' walls
  double period = 1e-3;                               // seconds
  double duration = 0;                                // seconds, that the loop ran
  bool asked_for_real_time = true;
  HapticRecord record = {};
  HapticRecord empty = {};                 // of the empty loop
  RefreshFigures refresh = {};             // none of full forces
  int coarse_triangles = 0;                // of a coarse body that leads the fine one; 0: none
  RefreshFigures corrections = {};         // of the coarse body's force by the fine one
  std::optional<PeerFigures> driver = {};  // where one moved the tool
  ForceError error = {};
  double full_change = 0;    // newton, largest of the full solution within a tick
  std::string failure = {};  // why the solver failed
};

std::string to_text(const HapticReport& report);
std::string to_json(const HapticReport& report, int exit_code);

/// A row for each tick: time_s,x_m,y_m,z_m,fx_N,fy_N,fz_N,wake_up_s,computation_s,model_age_s.
std::string tick_table(const HapticRecord& record);

}  // namespace thinwall
