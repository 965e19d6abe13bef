#pragma once

#include <string>

namespace thinwall {

/// A text with the span of time in which it holds.
struct TimedText {
  double begin = 0;  // seconds
  double end = 0;    // seconds
  std::string text;
  friend bool operator==(const TimedText&, const TimedText&) = default;
};

}  // namespace thinwall
