#pragma once

#include <optional>
#include <vector>

#include "engine/mesh/SurfaceMesh.hpp"
#include "engine/simulation/BodyState.hpp"
#include "engine/simulation/Puncture.hpp"

namespace thinwall {

/// A wall that has given way to a needle within a step. Under a needle that pierces, a step is divided where it would
/// work far more than a slit costs, and what has given way is asked for after each part. A wall that is held in its way
/// gives way at once, when its tip has gone in; it pays for that slit, evenly over its cone, and feels so much.
struct StepRupture {
  int tool = 0;
  SurfaceMesh uncut;  // the wall until then
  Rupture rupture = {};
  std::optional<ToolContact> felt = {};  // by the needle until then; nothing of what was held
};

/// What the last step took.
struct BodyStepReport {
  int newton_iterations = 0, shifted_iterations = 0, factorisations = 0;
  int ascending_steps = 0;       // of Newton's, along which the line search's energy was to rise at first
  int halvings = 0;              // how often the step was divided because it could not be solved
  int refinements = 0;           // how often it was divided to keep the error that is allowed
  int relaxations = 0;           // parts of it that were found with pseudo-inertia, see `relax`
  int bursts = 0;                // parts of it in which the body grew without end
  bool is_past_bearing = false;  // whether one asked for more pressure than the wall bears, as does then the whole step
  double residual = 0;           // newton
  double residual_share = 0;     // largest of the step's solutions, over the largest force there
  bool slowed = false;           // whether a drag slowed flaps that nothing holds, see Body::creep
  bool loose = false;            // whether a residual above the tolerance was taken, see NewtonOptions::takes_flaps
  bool unstable = false;         // whether it ended in an equilibrium that is not stable, see Body::buckle
  bool held = false;             // whether loads would turn it, which come to no rest, see Body::turn_to_rest
  bool crumpled = false;         // whether a blade crumpled the wall, which wrinkles infinitely finely from now on
  std::vector<StepRupture> ruptures = {};  // in their order
};

}  // namespace thinwall
