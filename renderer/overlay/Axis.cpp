#include "renderer/overlay/Axis.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/overlay/NumberText.hpp"

namespace thinwall {
namespace {

constexpr double kRoundoff = 1e-9;  // of a step: 0.3 / 0.1 is not quite 3

/// The smallest 1, 2 or 5 times a power of ten that is not below `smallest`.
double nice_step(double smallest) {
  const double power = std::pow(10.0, std::floor(std::log10(smallest)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= smallest * (1 - kRoundoff)) return factor * power;
  }
  return 10 * power;
}

Axis with_ticks(double lowest, double highest, double step) {
  Axis axis{.lowest = lowest, .highest = highest, .step = step, .ticks = {}};
  const double first = std::ceil(lowest / step - kRoundoff);
  const double last = std::floor(highest / step + kRoundoff);
  for (double i = first; i <= last; ++i) axis.ticks.push_back(i * step);
  return axis;
}

}  // namespace

std::string Axis::label(double tick) const {
  if (std::abs(tick) < kRoundoff * step) return "0";
  const int decimals = static_cast<int>(std::clamp(-std::floor(std::log10(step) + kRoundoff), 0.0, 9.0));
  return fixed_text(tick, decimals);
}

Axis growing_axis(double largest, int most_steps) {
  assert(largest > 0 && most_steps >= 2);
  constexpr double kHeadroom = 1.08;
  const double step = nice_step(kHeadroom * largest / most_steps);
  const double highest = std::max(2.0, std::ceil(kHeadroom * largest / step - kRoundoff)) * step;
  return with_ticks(0, highest, step);
}

Axis exact_axis(double lowest, double highest, int most_steps) {
  assert(highest > lowest);
  return with_ticks(lowest, highest, nice_step((highest - lowest) / most_steps));
}

Axis enclosing_axis(double lowest, double highest, int most_steps) {
  assert(highest > lowest);
  const double step = nice_step((highest - lowest) / most_steps);
  return with_ticks(std::floor(lowest / step + kRoundoff) * step, std::ceil(highest / step - kRoundoff) * step, step);
}

}  // namespace thinwall
