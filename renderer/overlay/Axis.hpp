#pragma once

#include <string>
#include <vector>

namespace thinwall {

/// An axis with marks at multiples of a step of 1, 2 or 5 times a power of ten.
struct Axis {
  double lowest = 0;
  double highest = 1;
  double step = 0.5;
  std::vector<double> ticks;  // ascending, within the ends

  double fraction(double value) const { return (value - lowest) / (highest - lowest); }
  /// The mark's number with as many decimals as the step needs.
  std::string label(double tick) const;
};

/// From 0 to the first multiple of the step that leaves 8 % above `largest`; two steps to `most_steps`, which is not
/// less. Grows with `largest` in jumps, so that a curve that grows does not pull the axis along all the time.
Axis growing_axis(double largest, int most_steps = 4);

/// Exactly from `lowest` to `highest` (which must be larger), with up to `most_steps` steps.
Axis exact_axis(double lowest, double highest, int most_steps);

/// Multiples of the step that enclose both, with up to about `most_steps` steps.
Axis enclosing_axis(double lowest, double highest, int most_steps);

}  // namespace thinwall
