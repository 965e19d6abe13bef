#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "studio/haptics/HapticReport.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// How a haptic loop comes by its forces.
enum class HapticForces {
  kAuto,   // full ones for bodies with few unknowns, else the local model
  kLocal,  // from a local model that full solutions beside the loop refresh
  kFull    // a full solution in each tick
};

struct HapticPlan {
  Scenario scenario;
  std::string tool;                                 // its name; empty: the first of the scenario
  std::optional<std::filesystem::path> trajectory;  // a recorded motion
  std::optional<std::filesystem::path> peer;        // a socket behind which a driver sits
  std::optional<double> duration;                   // seconds; absent: as long as the motion, of a peer until it ends
  HapticForces forces = HapticForces::kAuto;
  bool real_time = true;
  std::function<void()> throw_if_interrupted = [] {};
};

/// Drives a tool of the scenario by the hand that the plan names (the scenario's own timeline if none) through a loop
/// of 1 kHz in real time, and holds what the hand was given against the full solution at the scenario's time step along
/// the same motion. Throws InputErrors, PeerError, and SimulationFailure where the full solution itself fails; where
/// the solver behind the loop fails the report says so.
HapticReport run_haptics(const HapticPlan& plan);

}  // namespace thinwall
