#include "renderer/overlay/LegendTicks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/overlay/Axis.hpp"
#include "renderer/overlay/NumberText.hpp"

namespace thinwall {
namespace {

constexpr int kMostSteps = 5;

/// How many steps the whole range may have where gaps are filled, one after the other.
constexpr std::array kFinerSteps = {10, 25, 50};

/// Of the bar, between two numbers: what a line of small text takes, and a little air.
constexpr double kApart = 0.1;

}  // namespace

std::vector<LegendTick> legend_ticks(double from, double to, DataScale scale) {
  if (!(to > from)) return {{.value = from, .place = 0, .label = fixed_text(from, 2)}};
  std::vector<LegendTick> ticks;
  const auto tick_at = [&](const Axis& axis, double value) {
    return LegendTick{
        .value = value, .place = color_place((value - from) / (to - from), scale), .label = axis.label(value)};
  };
  const Axis even = exact_axis(from, to, kMostSteps);
  for (const double value : even.ticks) ticks.push_back(tick_at(even, value));
  if (scale == DataScale::kLinear) return ticks;
  for (const int steps : kFinerSteps) {
    const Axis finer = exact_axis(from, to, steps);
    for (const double value : finer.ticks) {
      const LegendTick tick = tick_at(finer, value);
      const auto is_near = [&](const LegendTick& other) { return std::abs(other.place - tick.place) < kApart; };
      if (std::ranges::none_of(ticks, is_near)) ticks.push_back(tick);
    }
  }
  std::ranges::sort(ticks, {}, &LegendTick::value);
  return ticks;
}

}  // namespace thinwall
