#pragma once

#include <algorithm>
#include <array>
#include <utility>

namespace thinwall {

/// A corner of a triangle on a square map, in texels from the map's corner.
struct MapCorner {
  double x = 0;
  double y = 0;
  double value = 0;  // goes on evenly between the corners
};

/// Texels of one row whose middles a triangle covers: from `first` up to, not with, `end`.
struct MapSpan {
  int row = 0;
  int first = 0;
  int end = 0;
  double value = 0;  // at the middle of the first
  double step = 0;   // from one to the next
};

/// The first texel of `count` in a row whose middle is at `place` or beyond; `count` where there is none.
inline int texel_from(double place, int count) {
  const double middle = std::clamp(place - 0.5, 0.0, static_cast<double>(count));
  const int below = static_cast<int>(middle);
  return below < middle ? below + 1 : below;
}

/// Calls `take` for the spans of a triangle on a map of `resolution` by `resolution` texels. Triangles that share an
/// edge share no texel and leave none out. For maps of many triangles that are hardly larger than a texel: what a
/// driver without a GPU does for each before it finds a texel takes three times as long.
template <typename Take>
void for_spans(std::array<MapCorner, 3> corners, int resolution, const Take& take) {
  auto& [low, middle, high] = corners;
  if (middle.y < low.y) std::swap(low, middle);
  if (high.y < middle.y) std::swap(middle, high);
  if (middle.y < low.y) std::swap(low, middle);
  const int first_row = texel_from(low.y, resolution), end_row = texel_from(high.y, resolution);
  if (first_row >= end_row) return;
  const double over = (middle.x - low.x) * (high.y - low.y) - (high.x - low.x) * (middle.y - low.y);
  if (over == 0) return;
  const double rise = (middle.value - low.value) / over, climb = (high.value - low.value) / over;
  const double across = rise * (high.y - low.y) - climb * (middle.y - low.y);
  const double along = climb * (middle.x - low.x) - rise * (high.x - low.x);
  const double long_side = (high.x - low.x) / (high.y - low.y);
  const double lower_side = (middle.x - low.x) / (middle.y - low.y);
  const double upper_side = (high.x - middle.x) / (high.y - middle.y);
  for (int row = first_row; row < end_row; ++row) {
    const double y = row + 0.5;
    const double one = low.x + (y - low.y) * long_side;
    const double other = y < middle.y ? low.x + (y - low.y) * lower_side : middle.x + (y - middle.y) * upper_side;
    const int first = texel_from(std::min(one, other), resolution), end = texel_from(std::max(one, other), resolution);
    if (first >= end) continue;
    take(MapSpan{row, first, end, low.value + across * (first + 0.5 - low.x) + along * (y - low.y), across});
  }
}

/// Twice the area of a triangle on a map, above zero where its corners go around it counter-clockwise.
inline double turn_of(const std::array<MapCorner, 3>& corners) {
  const auto& [a, b, c] = corners;
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace thinwall
