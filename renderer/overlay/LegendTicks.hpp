#pragma once

#include <string>
#include <vector>

#include "renderer/look/DataScale.hpp"

namespace thinwall {

/// A number beside the colours of a legend.
struct LegendTick {
  double value = 0;
  double place = 0;  // from 0 at the first colour to 1 at the last
  std::string label;
};

/// Round numbers from `from` to `to` (finite), ascending: evenly spaced ones; where a scale draws the low end out,
/// finer ones in its gaps. Where the range is empty, the one number that it holds.
std::vector<LegendTick> legend_ticks(double from, double to, DataScale scale);

}  // namespace thinwall
