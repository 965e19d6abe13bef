#include "renderer/wound/Bleeding.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {

double blood_shed(double age) {
  constexpr double kRate = 0.00015, kSlackening = 4;  // metres/second, seconds
  return kRate * kSlackening * (1 - std::exp(-std::max(age, 0.0) / kSlackening));
}

double dryness(double age) {
  constexpr double kDrying = 60;  // seconds
  return 1 - std::exp(-std::max(age, 0.0) / kDrying);
}

double run_length(double volume, double width, double depth, double age, double speed) {
  return std::min(volume / (width * depth), speed * std::max(age, 0.0));
}

}  // namespace thinwall
