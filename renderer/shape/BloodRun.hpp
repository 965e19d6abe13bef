#pragma once

#include "renderer/shape/RunFilm.hpp"

namespace thinwall {

/// What a run of blood is made of.
struct BloodRun {
  double most_half_width = 0;  // metres
  double volume = 0;           // metres^3
  double age = 0;              // seconds
  double way = 0;              // metres, as far as it goes
  bool creeps = false;
};

/// Half the width that a run of blood has at most, metres: thick walls have larger vessels. `thickness`: metres, where
/// the run begins.
double blood_half_width(const FluidRun& run, double thickness);

/// A run of blood: a thin line at first, that grows wider with what comes after it. What creeps over a level wall holds
/// together, and is no line.
RunShape blood_run(const BloodRun& run);

}  // namespace thinwall
