#pragma once

#include "engine/simulation/Body.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// A clip that fills or drains a chamber, with what was there when it began.
struct FillPlan {
  FillClip clip;
  int chamber = 0;            // index into the body's chambers
  double begin_pressure = 0;  // pascal

  double duration() const { return clip.duration; }  // seconds

  /// Adds what the clip puts in between two times, seconds since it began. `input` has all chambers.
  void add_to(BodyInput& input, double from, double to) const;
};

/// Throws InputErrors at `location` when the body has no such chamber, or several and the clip names none.
FillPlan plan_fill(const FillClip& clip, const Body& body, const SourceLocation& location);

/// The part of each load of a body at a time, seconds.
std::vector<double> load_factors(const BodyScenario& body, double time);

}  // namespace thinwall
