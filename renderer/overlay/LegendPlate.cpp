#include "renderer/overlay/LegendPlate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "renderer/look/ColorMap.hpp"
#include "renderer/overlay/LegendTicks.hpp"
#include "renderer/overlay/Text.hpp"

namespace thinwall {
namespace {

using namespace plate_style;

constexpr double kLegendPlateTop = 82;  // below title and time
constexpr double kWidth = 150;
constexpr double kLegendPlateHeight = 300;
constexpr double kBarTop = 64;  // below name and unit
constexpr double kBarWidth = 22;
constexpr double kSame = 1e-6;  // of the range

/// A unit as it is read, and how many of the SI unit it is.
struct ShownUnit {
  std::string unit;
  double size = 1;
};

ShownUnit shown_unit(const std::string& unit, double largest) {
  if (unit.empty()) return {"%", 0.01};
  if (unit == "m") return largest < 1e-3 ? ShownUnit{"\u00b5m", 1e-6} : ShownUnit{"mm", 1e-3};
  if (largest >= 1e6) return {"M" + unit, 1e6};
  return largest >= 1e3 ? ShownUnit{"k" + unit, 1e3} : ShownUnit{unit, 1};
}

void draw_bar(const Plate& plate, const OverlayGrid& grid, const Box& bar) {
  // Row by row of whole pixels: smoothed borders between rows would show as stripes.
  const int top = static_cast<int>(std::lround(bar.y)), bottom = static_cast<int>(std::lround(bar.bottom()));
  for (int row = top; row < bottom; ++row) {
    const Double3 color = color_map((bottom - row - 0.5) / (bottom - top));
    cairo_rectangle(plate.context(), bar.x, row, bar.width, 1);
    set_color(plate.context(), {color[0], color[1], color[2]});
    cairo_fill(plate.context());
  }
  plate.stroke_rounded(bar, 1, std::max(1.0, grid.unit), kEdge);
}

}  // namespace

Box legend_place(const OverlayGrid& grid, const Box& room, PictureCorner corner, const std::optional<Box>& inset) {
  const double width = grid.whole(kWidth), height = grid.whole(kLegendPlateHeight), margin = grid.whole(kMargin);
  const double left = room.x + margin, right = room.right() - margin - width;
  const double top = grid.whole(kLegendPlateTop);
  const double bottom = std::floor(grid.size.height - height_of_panels_and_captions(grid) - grid.pixels(kPadding));
  const Box place{is_left(corner) ? left : right, is_upper(corner) ? top : std::max(top, bottom - height), width,
                  height};
  if (!inset || !place.overlaps(*inset)) return place;
  Box past = place;
  past.y = is_upper(corner) ? inset->bottom() + grid.pixels(kPadding) : inset->y - grid.pixels(kPadding) - height;
  if (past.y >= top && past.bottom() <= grid.size.height - grid.pixels(kMargin + kPanelHeight + kPadding)) return past;
  // The action is in the middle, so that beside the inset it would be covered.
  return {is_left(corner) ? right : left, place.y, width, height};
}

void draw_legend(Image& image, const OverlayGrid& grid, const Legend& legend, const Box& place) {
  assert(std::isfinite(legend.from) && std::isfinite(legend.to));
  const ShownUnit unit = shown_unit(legend.unit, std::max(std::abs(legend.from), std::abs(legend.to)));
  const Plate plate(grid, {grid.whole(kWidth), grid.whole(kLegendPlateHeight)});
  const double padding = grid.pixels(kPadding);
  const double room = plate.size().width - 2 * padding;
  const Text name(legend.title, {.size = grid.pixels(kSmallText), .bold = true, .color = kText}, {.width = room});
  name.draw(plate, padding, grid.pixels(12));
  Text(unit.unit, {.size = grid.pixels(kSmallText), .color = kFaintText}).draw(plate, padding, grid.pixels(34));
  const Box bar{padding, grid.pixels(kBarTop), grid.pixels(kBarWidth),
                plate.size().height - grid.pixels(kBarTop + kPadding + 4)};
  draw_bar(plate, grid, bar);
  const double from = legend.from / unit.size, to = legend.to / unit.size;
  for (const LegendTick& tick : legend_ticks(from, to, legend.scale)) {
    const double y = bar.bottom() - bar.height * tick.place;
    plate.line(bar.right(), y, bar.right() + grid.pixels(5), y, std::max(1.0, grid.unit), kFaintText);
    const bool is_first = tick.value <= from + kSame * (to - from), is_last = tick.value >= to - kSame * (to - from);
    const char* sign = to > from && is_first && legend.goes_on_below  ? "\u2264 "
                       : to > from && is_last && legend.goes_on_above ? "\u2265 "
                                                                      : "";
    const Text number(sign + tick.label, {.size = grid.pixels(kSmallText), .color = kText});
    number.draw(plate, bar.right() + grid.pixels(10), y - number.height() / 2);
  }
  plate.blend_onto(image, static_cast<int>(place.x), static_cast<int>(place.y));
}

}  // namespace thinwall
