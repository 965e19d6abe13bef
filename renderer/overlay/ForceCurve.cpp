#include "renderer/overlay/ForceCurve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace thinwall {
namespace {

/// The points [begin, end) all lie in one pixel column.
void append_column(const std::vector<PlotPoint>& all, std::size_t begin, std::size_t end,
                   std::vector<PlotPoint>& kept) {
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = all.begin() + static_cast<std::ptrdiff_t>(end);
  const auto [low, high] =
      std::minmax_element(first, last, [](const PlotPoint& a, const PlotPoint& b) { return a.y < b.y; });
  std::array places{first, std::min(low, high), std::max(low, high), last - 1};
  const auto unique_end = std::unique(places.begin(), places.end());
  for (auto place = places.begin(); place != unique_end; ++place) kept.push_back(**place);
}

}  // namespace

std::vector<PlotPoint> curve_in_pixels(const std::vector<PlotPoint>& curve, const Axis& x, const Axis& y,
                                       const Box& area) {
  std::vector<PlotPoint> all;
  all.reserve(curve.size());
  for (const PlotPoint& point : curve) {
    all.push_back({area.x + area.width * x.fraction(point.x), area.bottom() - area.height * y.fraction(point.y)});
  }
  std::vector<PlotPoint> kept;
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin + 1;
    while (end < all.size() && std::floor(all[end].x) == std::floor(all[begin].x)) ++end;
    append_column(all, begin, end, kept);
    begin = end;
  }
  return kept;
}

void trace(const Canvas& canvas, const std::vector<PlotPoint>& points) {
  for (const PlotPoint& point : points) cairo_line_to(canvas.context(), point.x, point.y);
}

}  // namespace thinwall
