#pragma once

#include <limits>

namespace thinwall {

/// Allowed values of a number, SI.
struct Range {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool minimum_excluded = false;
  bool maximum_excluded = false;
};

/// Whether a number is allowed.
inline bool holds(const Range& range, double number) {
  const bool too_small = number < range.minimum || (range.minimum_excluded && number <= range.minimum);
  const bool too_large = number > range.maximum || (range.maximum_excluded && number >= range.maximum);
  return !too_small && !too_large;
}

}  // namespace thinwall
