#include "renderer/overlay/EnergyPlotImage.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "renderer/overlay/NumberText.hpp"
#include "renderer/overlay/PlotPage.hpp"

namespace thinwall {
namespace {

/// Of the largest term so far, what the books may be off by: shown as a line.
constexpr double kBar = 0.005;

/// Curves below this part of the largest one are left out.
constexpr double kLeastPart = 1e-3;

struct EnergyUnit {
  double joules;
  const char* name;
};
constexpr EnergyUnit kUnits[] = {{1, "J"}, {1e-3, "mJ"}, {1e-6, "µJ"}, {1e-9, "nJ"}};

struct EnergyTerm {
  const char* label;
  Color color;
  double EnergyPoint::*value;
};
constexpr EnergyTerm kTerms[] = {
    {"stored", {0.16, 0.40, 0.76}, &EnergyPoint::stored},      {"friction", {0.85, 0.37, 0.01}, &EnergyPoint::friction},
    {"fracture", {0.80, 0.24, 0.30}, &EnergyPoint::fracture},  {"viscous", {0.55, 0.31, 0.65}, &EnergyPoint::viscous},
    {"leak", {0.16, 0.55, 0.26}, &EnergyPoint::leak},          {"jump", {0.62, 0.52, 0.10}, &EnergyPoint::jump},
    {"numerical", {0.45, 0.45, 0.45}, &EnergyPoint::numerical}};

/// Since the first point.
double grown(const std::vector<EnergyPoint>& points, const EnergyPoint& point, double EnergyPoint::*value) {
  return point.*value - points.front().*value;
}

double put_in(const std::vector<EnergyPoint>& points, const EnergyPoint& point) {
  return grown(points, point, &EnergyPoint::tool_work) + grown(points, point, &EnergyPoint::script_work);
}

double largest_curve(const std::vector<EnergyPoint>& points) {
  double largest = 0;
  for (const EnergyPoint& point : points) {
    largest = std::max(largest, std::abs(put_in(points, point)));
    for (const EnergyTerm& term : kTerms) largest = std::max(largest, std::abs(grown(points, point, term.value)));
  }
  return largest;
}

EnergyUnit unit_for(double joules) {
  for (const EnergyUnit& unit : kUnits) {
    if (joules >= unit.joules) return unit;
  }
  return kUnits[std::size(kUnits) - 1];
}

Chart energy_chart(const std::vector<EnergyPoint>& points, const std::vector<ToolForces>& tools, double unit) {
  const double largest = largest_curve(points);
  const EnergyUnit energy = unit_for(largest);
  Chart chart{.x_title = "Time, s",
              .y_title = std::string("Energy since the beginning, ") + energy.name,
              .x = {},
              .y = {},
              .rows = {},
              .curves = {}};
  for (const ToolForces& tool : tools) chart.rows.push_back(phase_row(tool, tools.size() > 1 ? tool.tool : ""));
  PlotRange time, range;
  const auto add = [&](ChartCurve curve, const std::function<double(const EnergyPoint&)>& value) {
    for (const EnergyPoint& point : points) {
      time.include(point.time);
      range.include(value(point) / energy.joules);
      curve.points.push_back({point.time, value(point) / energy.joules});
    }
    chart.curves.push_back(std::move(curve));
  };
  for (const EnergyTerm& term : kTerms) {
    const auto value = [&](const EnergyPoint& point) { return grown(points, point, term.value); };
    const bool is_seen =
        std::ranges::any_of(points, [&](const auto& point) { return std::abs(value(point)) > kLeastPart * largest; });
    if (!is_seen) continue;
    add({.label = term.label, .color = term.color, .line_width = 2 * unit, .dashes = {}, .points = {}}, value);
  }
  add({.label = "sum", .color = kPageInk, .line_width = 2.8 * unit, .dashes = {}, .points = {}},
      [&](const EnergyPoint& point) {
        return grown(points, point, &EnergyPoint::stored) + point.spent() - points.front().spent();
      });
  add({.label = "work put in",
       .color = {0.98, 0.80, 0.20},
       .line_width = 2.2 * unit,
       .dashes = {7 * unit, 7 * unit},
       .points = {}},
      [&](const EnergyPoint& point) { return put_in(points, point); });
  time.widen();
  range.widen();
  chart.x = exact_axis(time.lowest, time.highest, 10);
  chart.y = enclosing_axis(range.lowest, 1.02 * range.highest, 8);
  return chart;
}

/// Parts of the largest term so far: what the integrator spent, and what the books leave open.
struct BooksPart {
  double time = 0;
  double numerical = 0;
  double open = 0;
};

std::vector<BooksPart> books_parts(const std::vector<EnergyPoint>& points) {
  std::vector<BooksPart> parts;
  double largest = 0;
  for (const EnergyPoint& point : points) {
    largest = std::max(largest, point.largest_term());
    const double scale = largest > 0 ? 1 / largest : 0;
    parts.push_back({point.time, std::abs(point.numerical) * scale, std::abs(point.imbalance()) * scale});
  }
  return parts;
}

Chart books_chart(const std::vector<EnergyPoint>& points, double unit) {
  Chart chart{.x_title = "Time, s",
              .y_title = "Part of the largest term so far, %",
              .x = {},
              .y = {},
              .rows = {},
              .curves = {}};
  ChartCurve numerical{
      .label = "numerical", .color = {0.16, 0.40, 0.76}, .line_width = 2.4 * unit, .dashes = {}, .points = {}};
  ChartCurve open{.label = "open", .color = {0.80, 0.24, 0.30}, .line_width = 2 * unit, .dashes = {}, .points = {}};
  ChartCurve bar{.label = fixed_text(100 * kBar, 1) + " %",
                 .color = kFaintPageInk,
                 .line_width = 1.6 * unit,
                 .dashes = {9 * unit, 5 * unit},
                 .points = {}};
  PlotRange time, range;
  range.include(100 * kBar);
  for (const BooksPart& part : books_parts(points)) {
    time.include(part.time);
    range.include(100 * std::max(part.numerical, part.open));
    numerical.points.push_back({part.time, 100 * part.numerical});
    open.points.push_back({part.time, 100 * part.open});
  }
  time.widen();
  bar.points = {{time.lowest, 100 * kBar}, {time.highest, 100 * kBar}};
  chart.curves = {std::move(numerical), std::move(open), std::move(bar)};
  chart.x = exact_axis(time.lowest, time.highest, 5);
  chart.y = enclosing_axis(range.lowest, 1.02 * range.highest, 8);
  return chart;
}

std::string summary(const std::vector<EnergyPoint>& points) {
  if (points.empty()) return "No energies were recorded.";
  double numerical = 0;
  for (const BooksPart& part : books_parts(points)) numerical = std::max(numerical, part.numerical);
  const EnergyUnit unit = unit_for(largest_curve(points));
  return "Work put in " + fixed_text(put_in(points, points.back()) / unit.joules, 3) + " " + unit.name +
         "; the integrator spent at most " + fixed_text(100 * numerical, 2) + " % of the largest term so far";
}

}  // namespace

double EnergyPoint::largest_term() const {
  double largest = std::max(std::abs(tool_work), std::abs(script_work));
  for (const EnergyTerm& term : kTerms) largest = std::max(largest, std::abs(this->*term.value));
  return largest;
}

Image energy_plot_image(const std::string& title, const std::vector<EnergyPoint>& points,
                        const std::vector<ToolForces>& tools, ImageSize size) {
  const double unit = page_unit(size);
  return plot_page({.title = title,
                    .summary = summary(points),
                    .left = energy_chart(points, tools, unit),
                    .right = books_chart(points, unit)},
                   size);
}

}  // namespace thinwall
