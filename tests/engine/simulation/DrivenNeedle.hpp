#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "engine/simulation/Body.hpp"

namespace thinwall {

/// A needle of 0.5 mm radius that reaches through any body of the tests.
ToolDefinition test_needle(double friction);

/// The needle that is the only tool of a body, on its way along a straight line.
struct DrivenNeedle {
  Eigen::Vector3d at;                                     // metres, where its tip is at depth zero
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();  // unit
  double step = 0.2e-3;                                   // metres
  double duration = 5e-3;                                 // seconds, of a step
  bool pierces = true;                                    // or dents, whatever it does
  double depth = 0;                                       // metres
  std::vector<double> forces = {};                        // newton, against its way in, after each step
  std::vector<Rupture> ruptures = {};                     // so far
  std::vector<double> ruptured_at = {};                   // metres, their depths

  /// Moves it to a depth in equal steps; calls `after_step` after each.
  void move(Body& body, double to, const std::function<void()>& after_step = {});

  /// Moves it in until the wall has given way so many times, or to the given depth. Says whether it has.
  bool move_to_rupture(Body& body, std::size_t count, double most, const std::function<void()>& after_step = {});
};

}  // namespace thinwall
