#include "renderer/overlay/PlotPlate.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "renderer/overlay/Axis.hpp"
#include "renderer/overlay/ForceCurve.hpp"
#include "renderer/overlay/NumberText.hpp"
#include "renderer/overlay/Text.hpp"
#include "renderer/overlay/ToolNames.hpp"

namespace thinwall {
namespace {

using plate_style::kPadding;
using plate_style::kSmallText;

constexpr double kHeadingMiddle = 22;  // below the plate's top, as kNameRow in units of the grid
constexpr double kNameRow = 18;

/// Of lines of tools by their numbers; none is that of a compared take or of a force's arrow.
constexpr Color kToolCurves[] = {plate_style::kCurve, {0.80, 0.62, 0.98}, {0.60, 0.86, 0.45},
                                 {0.98, 0.55, 0.64},  {0.55, 0.64, 0.98}, {0.86, 0.88, 0.90}};

Color tool_color(std::size_t number) {
  return kToolCurves[number % std::size(kToolCurves)];
}

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

/// `rows` of names stand between the heading and the axes, which have as many steps less.
ForcePlot plot_for(const Plate& plate, const OverlayGrid& grid, const OverlayContent& content, double peak, int rows) {
  constexpr double kSmallestPeak = 0.01;  // in the unit: below that an empty plot would show the solver's last digits
  const ForceUnit unit = force_unit(content.expected_force, peak);
  const double end = content.history.empty() ? 0 : content.history.back().time;
  const double longest = std::max({content.duration, content.time, end});
  ForcePlot plot{.time = {},
                 .force = growing_axis(std::max(peak / unit.newton, kSmallestPeak), 4 - rows),
                 .unit = unit,
                 .area = {}};
  double label_width = 0;
  for (const double tick : plot.force.ticks) {
    label_width = std::max(label_width, Text(plot.force.label(tick), label_style(grid)).width());
  }
  const double left = grid.pixels(kPadding + 9) + label_width;
  const double top = grid.pixels(42 + rows * kNameRow);
  plot.area = {left, top, plate.size().width - grid.pixels(kPadding + 4) - left,
               plate.size().height - grid.pixels(33) - top};
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

std::vector<PlotPoint> points_of(const ForcePlot& plot, const std::vector<ForceSample>& history) {
  std::vector<PlotPoint> curve;
  curve.reserve(history.size());
  for (const ForceSample& sample : history) curve.push_back({sample.time, sample.force / plot.unit.newton});
  return curve_in_pixels(curve, plot.time, plot.force, plot.area);
}

void draw_other_tool(const Plate& plate, const OverlayGrid& grid, const ForcePlot& plot, const ToolHistory& tool) {
  const std::vector<PlotPoint> points = points_of(plot, tool.samples);
  if (points.empty()) return;
  trace(plate, points);
  set_color(plate.context(), tool_color(tool.number));
  cairo_set_line_join(plate.context(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_width(plate.context(), std::max(1.2, grid.pixels(1.8)));
  cairo_stroke(plate.context());
}

/// Which colour is which tool.
std::vector<ToolName> tool_names(const Plate& plate, const OverlayGrid& grid, const OverlayContent& content,
                                 double heading) {
  if (content.other_tools.empty()) return {};
  std::vector<std::pair<std::size_t, std::string>> tools = {{content.tool_number, content.tool}};
  for (const ToolHistory& other : content.other_tools) tools.emplace_back(other.number, other.tool);
  std::ranges::sort(tools);
  return place_tool_names(tools, label_style(grid),
                          {.heading = grid.pixels(kPadding + 12) + heading,
                           .left = grid.pixels(kPadding),
                           .right = plate.size().width - grid.pixels(kPadding + 4),
                           .dash = grid.pixels(12),
                           .space = grid.pixels(5),
                           .gap = grid.pixels(12)});
}

void draw_tool_names(const Plate& plate, const OverlayGrid& grid, const std::vector<ToolName>& names) {
  for (const ToolName& name : names) {
    const double middle = grid.pixels(kHeadingMiddle + name.row * kNameRow);
    const double dash = name.left - grid.pixels(5);
    name.text.draw(plate, name.left, middle - name.text.height() / 2);
    plate.line(dash - grid.pixels(12), middle, dash, middle, std::max(1.5, grid.pixels(2.4)), tool_color(name.number));
  }
}

/// The force of the take in the right half: a line of another colour, dashed, without a mark.
void draw_other_curve(const Plate& plate, const OverlayGrid& grid, const ForcePlot& plot,
                      const std::vector<ForceSample>& history) {
  const std::vector<PlotPoint> points = points_of(plot, history);
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
  const std::vector<PlotPoint> points = points_of(plot, content.history);
  if (points.empty()) return;
  const Color color = tool_color(content.tool_number);
  cairo_t* context = plate.context();
  cairo_new_path(context);
  cairo_move_to(context, points.front().x, plot.area.bottom());
  trace(plate, points);
  cairo_line_to(context, points.back().x, plot.area.bottom());
  set_color(context, color.with_opacity(0.14));
  cairo_fill(context);
  trace(plate, points);
  set_color(context, color);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_width(context, std::max(1.2, grid.pixels(2.2)));
  cairo_stroke(context);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
  const PlotPoint now = points.back();
  plate.fill_circle(now.x, now.y, grid.pixels(8), color.with_opacity(0.25));
  plate.fill_circle(now.x, now.y, std::max(1.5, grid.pixels(4)), plate_style::kText);
}

}  // namespace

void draw_force_plot(Image& image, const OverlayGrid& grid, const OverlayContent& content, double peak) {
  const Plate plate(grid, {grid.whole(plate_style::kPlotWidth), grid.whole(plate_style::kPanelHeight)});
  const ForceUnit unit = force_unit(content.expected_force, peak);
  const Text heading(std::string("Force, ") + unit.name,
                     {.size = grid.pixels(kSmallText + 1), .color = plate_style::kFaintText});
  heading.draw(plate, grid.pixels(kPadding), grid.pixels(kHeadingMiddle) - heading.height() / 2);
  const std::vector<ToolName> names = tool_names(plate, grid, content, heading.width());
  draw_tool_names(plate, grid, names);
  const ForcePlot plot = plot_for(plate, grid, content, peak, names.empty() ? 0 : names.back().row);
  draw_axes(plate, grid, plot);
  for (const ToolHistory& other : content.other_tools) draw_other_tool(plate, grid, plot, other);
  draw_other_curve(plate, grid, plot, content.other_history);
  draw_curve(plate, grid, plot, content);
  const int margin = grid.whole(plate_style::kMargin);
  plate.blend_onto(image, image.size.width - margin - plate.size().width,
                   image.size.height - margin - plate.size().height);
}

}  // namespace thinwall
