#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "engine/simulation/Body.hpp"

namespace thinwall {

/// A scalpel that reaches through any body of the tests.
ToolDefinition test_blade();

struct BladeStroke {
  std::vector<Eigen::Vector3d> points;                    // metres, of the blade's tip, at least one
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();  // unit, into the wall
  double step = 1e-3;                                     // metres of way
  double duration = 5e-3;                                 // seconds, of a step
  // Whether the blade comes down on a wall that it would stand in, unmet by its middle: a wall in motion would be flung
  // out of it.
  bool comes_down = false;
  // Whether the cut ends where the blade does: the last step is told to be the last one.
  bool ends = false;
};

/// Draws the blade that is the only tool of a body through its wall, from one point to the next one, and lets the
/// cut run ahead straight on. Gives the cuts in their order; calls `after_step` after each step and `after_cut` after
/// each cut. The blade leaves the wall in the end.
std::vector<Cut> draw_blade(Body& body, const BladeStroke& stroke, const std::function<void()>& after_step = {},
                            const std::function<void(const Cut&)>& after_cut = {});

}  // namespace thinwall
