#include "renderer/overlay/PlotPlate.hpp"

#include <algorithm>

#include "renderer/overlay/Axis.hpp"
#include "renderer/overlay/ForceCurve.hpp"
#include "renderer/overlay/Text.hpp"

namespace thinwall {
namespace {

using plate_style::kPadding;
using plate_style::kSmallText;

struct ForceUnit {
  double newton;
  const char* name;
};

/// The axes and where they lie in the plate.
struct ForcePlot {
  Axis time;
  Axis force;  // in `unit`
  ForceUnit unit;
  Box area;
};

TextStyle label_style(const OverlayGrid& grid) {
  return {.size = grid.pixels(kSmallText), .color = plate_style::kFaintText};
}

/// As many marks as have room for their numbers.
Axis time_axis(double longest, const OverlayGrid& grid, double room) {
  for (int steps = 6;; --steps) {
    Axis axis = exact_axis(0, longest, steps);
    const double needed = Text(axis.label(axis.ticks.back()), label_style(grid)).width() + grid.pixels(14);
    if (steps == 1 || needed * static_cast<double>(axis.ticks.size()) <= room) return axis;
  }
}

ForcePlot plot_for(const Plate& plate, const OverlayGrid& grid, const OverlayContent& content, double peak) {
  constexpr double kSmallestPeak = 0.01;  // newton: below that an empty plot would show the solver's last digits
  const ForceUnit unit = peak >= 1e4 ? ForceUnit{1e3, "kN"} : ForceUnit{1, "N"};
  const double end = content.history.empty() ? 0 : content.history.back().time;
  const double longest = std::max({content.duration, content.time, end});
  ForcePlot plot{
      .time = {}, .force = growing_axis(std::max(peak, kSmallestPeak) / unit.newton), .unit = unit, .area = {}};
  double label_width = 0;
  for (const double tick : plot.force.ticks) {
    label_width = std::max(label_width, Text(plot.force.label(tick), label_style(grid)).width());
  }
  const double left = grid.pixels(kPadding + 9) + label_width;
  const double top = grid.pixels(46);
  plot.area = {left, top, plate.size().width - grid.pixels(kPadding + 4) - left,
               plate.size().height - grid.pixels(34) - top};
  plot.time = time_axis(longest > 0 ? longest : 1, grid, plot.area.width);
  return plot;
}

void draw_axes(const Plate& plate, const OverlayGrid& grid, const ForcePlot& plot) {
  const Box& area = plot.area;
  const double hairline = std::max(1.0, grid.unit);
  for (const double tick : plot.force.ticks) {
    const double y = area.bottom() - area.height * plot.force.fraction(tick);
    const double strength = tick == 0 ? 0.4 : plate_style::kGridLine.opacity;
    plate.line(area.x, y, area.right(), y, hairline, plate_style::kGridLine.with_opacity(strength));
    const Text label(plot.force.label(tick), label_style(grid));
    label.draw(plate, area.x - grid.pixels(9) - label.width(), y - label.height() / 2);
  }
  for (const double tick : plot.time.ticks) {
    const double x = area.x + area.width * plot.time.fraction(tick);
    plate.line(x, area.bottom(), x, area.bottom() + grid.pixels(4), hairline, plate_style::kGridLine.with_opacity(0.4));
    const bool is_last = tick == plot.time.ticks.back();
    const Text number(plot.time.label(tick), label_style(grid));
    const Text label(plot.time.label(tick) + (is_last ? " s" : ""), label_style(grid));
    const double right = plate.size().width - grid.pixels(kPadding - 6);
    label.draw(plate, std::min(x - number.width() / 2, right - label.width()), area.bottom() + grid.pixels(7));
  }
}

/// The force of the take in the right half: a line of another colour, dashed, without a mark.
void draw_other_curve(const Plate& plate, const OverlayGrid& grid, const ForcePlot& plot,
                      const std::vector<ForceSample>& history) {
  std::vector<PlotPoint> curve;
  for (const ForceSample& sample : history) curve.push_back({sample.time, sample.force / plot.unit.newton});
  const std::vector<PlotPoint> points = curve_in_pixels(curve, plot.time, plot.force, plot.area);
  if (points.empty()) return;
  cairo_t* context = plate.context();
  trace(plate, points);
  const double dashes[] = {grid.pixels(6), grid.pixels(4)};
  cairo_set_dash(context, dashes, 2, 0);
  set_color(context, plate_style::kOtherCurve);
  cairo_set_line_width(context, std::max(1.2, grid.pixels(2)));
  cairo_stroke(context);
  cairo_set_dash(context, nullptr, 0, 0);
}

void draw_curve(const Plate& plate, const OverlayGrid& grid, const ForcePlot& plot, const OverlayContent& content) {
  std::vector<PlotPoint> curve;
  curve.reserve(content.history.size());
  for (const ForceSample& sample : content.history) curve.push_back({sample.time, sample.force / plot.unit.newton});
  const std::vector<PlotPoint> points = curve_in_pixels(curve, plot.time, plot.force, plot.area);
  if (points.empty()) return;
  cairo_t* context = plate.context();
  cairo_new_path(context);
  cairo_move_to(context, points.front().x, plot.area.bottom());
  trace(plate, points);
  cairo_line_to(context, points.back().x, plot.area.bottom());
  set_color(context, plate_style::kCurve.with_opacity(0.14));
  cairo_fill(context);
  trace(plate, points);
  set_color(context, plate_style::kCurve);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_width(context, std::max(1.2, grid.pixels(2.2)));
  cairo_stroke(context);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
  const PlotPoint now = points.back();
  plate.fill_circle(now.x, now.y, grid.pixels(8), plate_style::kCurve.with_opacity(0.25));
  plate.fill_circle(now.x, now.y, std::max(1.5, grid.pixels(4)), plate_style::kText);
}

}  // namespace

void draw_force_plot(Image& image, const OverlayGrid& grid, const OverlayContent& content, double peak) {
  const Plate plate(grid, {grid.whole(plate_style::kPlotWidth), grid.whole(plate_style::kPanelHeight)});
  const ForcePlot plot = plot_for(plate, grid, content, peak);
  const Text heading(std::string("Force, ") + plot.unit.name,
                     {.size = grid.pixels(kSmallText + 1), .color = plate_style::kFaintText});
  heading.draw(plate, grid.pixels(kPadding), grid.pixels(24) - heading.height() / 2);
  draw_axes(plate, grid, plot);
  draw_other_curve(plate, grid, plot, content.other_history);
  draw_curve(plate, grid, plot, content);
  const int margin = grid.whole(plate_style::kMargin);
  plate.blend_onto(image, image.size.width - margin - plate.size().width,
                   image.size.height - margin - plate.size().height);
}

}  // namespace thinwall
