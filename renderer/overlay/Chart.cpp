#include "renderer/overlay/Chart.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/overlay/Text.hpp"

namespace thinwall {
namespace {

constexpr Color kInk{0.10, 0.13, 0.17};
constexpr Color kFaintInk{0.38, 0.42, 0.47};
constexpr Color kGrid{0.10, 0.13, 0.17, 0.12};
constexpr double kTextSize = 15;
constexpr double kLegendHeight = 30;
constexpr double kTitleHeight = 36;  // of the vertical axis
constexpr double kRowHeight = 24;

/// What the helpers below draw on.
struct ChartFrame {
  const Canvas& canvas;
  const Chart& chart;
  double unit = 1;  // pixels
  Box box;          // of all
  Box area;         // inside the axes

  TextStyle style(Color color) const { return {.size = kTextSize * unit, .color = color}; }
  double x(double value) const { return area.x + area.width * chart.x.fraction(value); }
  double y(double value) const { return area.bottom() - area.height * chart.y.fraction(value); }
};

/// A pastel for areas, a dark tone for words.
Color darkened(Color color) {
  return {0.5 * color.red, 0.5 * color.green, 0.5 * color.blue};
}

/// Of all rows of bands, in pixels, with a gap to the area where they do not reach into it.
double rows_height(const ChartFrame& frame) {
  const double gap = frame.chart.rows.size() > 1 ? 8 : 0;
  return (static_cast<double>(frame.chart.rows.size()) * kRowHeight + gap) * frame.unit;
}

Box chart_area(const ChartFrame& frame) {
  double label_width = 0;
  for (const double tick : frame.chart.y.ticks) {
    label_width = std::max(label_width, Text(frame.chart.y.label(tick), frame.style(kInk)).width());
  }
  for (const ChartBandRow& row : frame.chart.rows) {
    const double most = frame.box.width / 6;
    label_width = std::max(label_width, std::min(most, Text(row.name, frame.style(kInk)).width()));
  }
  const double left = frame.box.x + label_width + 12 * frame.unit;
  const double top = frame.box.y + (kLegendHeight + kTitleHeight) * frame.unit + rows_height(frame);
  const double bottom = frame.box.bottom() - 56 * frame.unit;
  return {left, top, frame.box.right() - left, bottom - top};
}

void draw_dashed(const ChartFrame& frame, const ChartCurve& curve) {
  cairo_t* context = frame.canvas.context();
  cairo_set_dash(context, curve.dashes.data(), static_cast<int>(curve.dashes.size()), 0);
  set_color(context, curve.color);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_width(context, curve.line_width);
  cairo_stroke(context);
  cairo_set_dash(context, nullptr, 0, 0);
}

/// What stands beside the words of a legend, in units, and how much closer it is set so that all entries fit.
constexpr double kLegendLine = 30, kLegendGap = 9, kLegendSpace = 22;
constexpr double kClosestLegend = 0.5;

double legend_tightness(const ChartFrame& frame) {
  double words = 0, beside = -kLegendSpace * frame.unit;
  for (const ChartCurve& curve : frame.chart.curves) {
    if (curve.label.empty()) continue;
    words += Text(curve.label, frame.style(kInk)).width();
    beside += (kLegendLine + kLegendGap + kLegendSpace) * frame.unit;
  }
  const double room = frame.box.right() - frame.area.x - words;
  return beside <= room ? 1 : std::max(kClosestLegend, room / beside);
}

void draw_legend(const ChartFrame& frame) {
  double x = frame.area.x;
  const double middle = frame.box.y + kLegendHeight / 2 * frame.unit;
  const double unit = legend_tightness(frame) * frame.unit;
  for (const ChartCurve& curve : frame.chart.curves) {
    if (curve.label.empty()) continue;
    const Text text(curve.label, frame.style(kInk));
    const double width = (kLegendLine + kLegendGap + kLegendSpace) * unit + text.width();
    if (x + width > frame.box.right() + (kLegendSpace + 1) * unit) break;
    cairo_move_to(frame.canvas.context(), x, middle);
    cairo_line_to(frame.canvas.context(), x + kLegendLine * unit, middle);
    draw_dashed(frame, curve);
    text.draw(frame.canvas, x + (kLegendLine + kLegendGap) * unit, middle - text.height() / 2);
    x += width;
  }
}

void draw_band(const ChartFrame& frame, const ChartBand& band, double row_top, bool reaches_down) {
  const double left = frame.x(std::max(band.begin, frame.chart.x.lowest));
  const double width = frame.x(std::min(band.end, frame.chart.x.highest)) - left;
  if (width <= 0) return;
  const Box strip{left, row_top, width, (kRowHeight - 4) * frame.unit};
  frame.canvas.fill_rounded(strip, 0, band.color.with_opacity(0.42));
  if (reaches_down) {
    frame.canvas.fill_rounded({left, frame.area.y, width, frame.area.height}, 0, band.color.with_opacity(0.13));
  }
  TextStyle style = frame.style(darkened(band.color));
  style.size *= 0.87;
  const Text text(band.label, style);
  if (text.width() + 6 * frame.unit > width) return;
  text.draw(frame.canvas, left + (width - text.width()) / 2, strip.y + (strip.height - text.height()) / 2);
}

void draw_bands(const ChartFrame& frame) {
  double top = frame.area.y - rows_height(frame);
  for (std::size_t row = 0; row < frame.chart.rows.size(); ++row, top += kRowHeight * frame.unit) {
    const ChartBandRow& bands = frame.chart.rows[row];
    for (const ChartBand& band : bands.bands) draw_band(frame, band, top, row == 0 && frame.chart.rows.size() == 1);
    if (bands.name.empty()) continue;
    const Text name(bands.name, frame.style(kFaintInk), {.width = std::max(1.0, frame.area.x - frame.box.x)});
    name.draw(frame.canvas, frame.area.x - 8 * frame.unit - name.width(), top);
  }
}

void draw_axes(const ChartFrame& frame) {
  const double hairline = std::max(1.0, frame.unit);
  for (const double tick : frame.chart.y.ticks) {
    const double y = frame.y(tick);
    frame.canvas.line(frame.area.x, y, frame.area.right(), y, hairline, tick == 0 ? kFaintInk : kGrid);
    const Text label(frame.chart.y.label(tick), frame.style(kFaintInk));
    label.draw(frame.canvas, frame.area.x - 8 * frame.unit - label.width(), y - label.height() / 2);
  }
  for (const double tick : frame.chart.x.ticks) {
    const double x = frame.x(tick);
    frame.canvas.line(x, frame.area.y, x, frame.area.bottom(), hairline, kGrid);
    const Text label(frame.chart.x.label(tick), frame.style(kFaintInk));
    label.draw(frame.canvas, x - label.width() / 2, frame.area.bottom() + 8 * frame.unit);
  }
  const Text x_title(frame.chart.x_title, frame.style(kInk));
  x_title.draw(frame.canvas, frame.area.x + (frame.area.width - x_title.width()) / 2,
               frame.box.bottom() - x_title.height());
  const Text y_title(frame.chart.y_title, frame.style(kInk));
  y_title.draw(frame.canvas, frame.box.x, frame.area.y - rows_height(frame) - 13 * frame.unit - y_title.height());
}

void draw_curves(const ChartFrame& frame) {
  cairo_t* context = frame.canvas.context();
  cairo_save(context);
  // A curve's width may reach over the axes, its points never do.
  cairo_rectangle(context, frame.area.x - 4, frame.area.y - 4, frame.area.width + 8, frame.area.height + 8);
  cairo_clip(context);
  for (const ChartCurve& curve : frame.chart.curves) {
    trace(frame.canvas, curve_in_pixels(curve.points, frame.chart.x, frame.chart.y, frame.area));
    draw_dashed(frame, curve);
  }
  cairo_restore(context);
}

}  // namespace

void draw_chart(const Canvas& canvas, const Box& box, double unit, const Chart& chart) {
  ChartFrame frame{.canvas = canvas, .chart = chart, .unit = unit, .box = box, .area = {}};
  frame.area = chart_area(frame);
  draw_bands(frame);
  draw_axes(frame);
  draw_curves(frame);
  draw_legend(frame);
}

}  // namespace thinwall
