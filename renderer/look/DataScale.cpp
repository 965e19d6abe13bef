#include "renderer/look/DataScale.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {

const DataScale* find_data_scale(std::string_view word) {
  const auto* row = std::ranges::find(kDataScales, word, &std::pair<std::string_view, DataScale>::first);
  return row == kDataScales.end() ? nullptr : &row->second;
}

double color_place(double place, DataScale scale) {
  const double clamped = std::clamp(place, 0.0, 1.0);
  return scale == DataScale::kRoot ? std::sqrt(clamped) : clamped;
}

}  // namespace thinwall
