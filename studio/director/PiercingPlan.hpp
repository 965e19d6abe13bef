#pragma once

#include <vector>

#include "studio/director/ClipPlan.hpp"

namespace thinwall {

/// A needle on its way through a wall: moves as a palpation does, and tells when walls have given way.
struct PiercingPlan : PalpationPlan {
  std::vector<double> ruptures;  // seconds since the clip began, ascending, as they were felt

  ToolMoment at(double time) const;  // phase `rupture` at a rupture, `sliding` after the first until the hold
  /// `time`: seconds since the clip began at the end of the step in which a wall gave way.
  void feel_rupture(double time) { ruptures.push_back(time); }
};

/// As `plan_palpation`. Throws InputErrors at `location` also when the needle is thicker than the body is wide across
/// its way, thinner than triangles can be cut for it, or goes deeper than it is long.
PiercingPlan plan_piercing(const PierceClip& clip, const ToolDefinition& tool, const SurfaceView& surface,
                           const SourceLocation& location);

}  // namespace thinwall
