#include "renderer/overlay/ForcePlotImage.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/overlay/Chart.hpp"
#include "renderer/overlay/NumberText.hpp"
#include "renderer/overlay/PlotPage.hpp"

namespace thinwall {
namespace {

constexpr const char* kAxisNames[] = {"x", "y", "z"};
constexpr Color kComponentColors[] = {{0.80, 0.24, 0.30}, {0.16, 0.55, 0.26}, {0.16, 0.40, 0.76}};
constexpr Color kToolColors[] = {{0.10, 0.13, 0.17}, {0.85, 0.37, 0.01}, {0.11, 0.47, 0.67},
                                 {0.55, 0.31, 0.65}, {0.20, 0.55, 0.33}, {0.75, 0.23, 0.35}};

double magnitude(const ForcePoint& point) {
  return std::hypot(point.force[0], point.force[1], point.force[2]);
}

struct Peak {
  double force = -1;  // newton
  double time = 0;    // seconds
  std::string tool;
};

Peak peak_of(const std::vector<ToolForces>& tools) {
  Peak peak;
  for (const ToolForces& tool : tools) {
    for (const ForcePoint& point : tool.points) {
      if (magnitude(point) > peak.force) peak = {magnitude(point), point.time, tool.tool};
    }
  }
  return peak;
}

ChartCurve curve_of(const ToolForces& tool, auto x_of, auto y_of) {
  ChartCurve curve;
  curve.points.reserve(tool.points.size());
  for (const ForcePoint& point : tool.points) curve.points.push_back({x_of(point), y_of(point)});
  return curve;
}

std::vector<double> component_dashes(std::size_t axis, double unit) {
  if (axis == 0) return {9 * unit, 5 * unit};
  if (axis == 1) return {2 * unit, 4 * unit};
  return {9 * unit, 4 * unit, 2 * unit, 4 * unit};
}

/// Several tools share the dashes of the components, which only a legend without curve explains.
void add_component_legend(Chart& chart, double unit) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    chart.curves.push_back({.label = std::string("F") + kAxisNames[axis],
                            .color = kFaintPageInk,
                            .line_width = 1.6 * unit,
                            .dashes = component_dashes(axis, unit),
                            .points = {}});
  }
}

/// One tool: a colour for each component. Several tools: a colour for each tool, dashes for the components.
void add_time_curves(Chart& chart, const std::vector<ToolForces>& tools, std::size_t number, double unit) {
  const ToolForces& tool = tools[number];
  const bool is_alone = tools.size() == 1;
  const Color color = kToolColors[number % std::size(kToolColors)];
  const auto time = [](const ForcePoint& point) { return point.time; };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ChartCurve curve = curve_of(tool, time, [&](const ForcePoint& point) { return point.force[axis]; });
    if (is_alone) curve.label = std::string("F") + kAxisNames[axis];
    curve.color = is_alone ? kComponentColors[axis] : color.with_opacity(0.75);
    curve.line_width = 1.6 * unit;
    if (!is_alone) curve.dashes = component_dashes(axis, unit);
    chart.curves.push_back(std::move(curve));
  }
  ChartCurve whole = curve_of(tool, time, magnitude);
  whole.label = is_alone ? "magnitude" : tool.tool;
  whole.color = color;
  whole.line_width = 2.8 * unit;
  chart.curves.push_back(std::move(whole));
}

Chart time_chart(const std::vector<ToolForces>& tools, ForceUnit forces, double unit) {
  const std::string title = std::string("Force on the tool, ") + forces.name;
  Chart chart{.x_title = "Time, s", .y_title = title, .x = {}, .y = {}, .rows = {}, .curves = {}};
  PlotRange time;
  PlotRange force;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    for (const ForcePoint& point : tools[i].points) {
      time.include(point.time);
      force.include(magnitude(point));
      for (const double component : point.force) force.include(component);
    }
    chart.rows.push_back(phase_row(tools[i], tools.size() > 1 ? tools[i].tool : ""));
    add_time_curves(chart, tools, i, unit);
  }
  if (tools.size() > 1) add_component_legend(chart, unit);
  time.widen();
  force.widen();
  chart.x = exact_axis(time.lowest, time.highest, 10);
  chart.y = enclosing_axis(force.lowest, 1.02 * force.highest, 8);
  return chart;
}

Chart depth_chart(const std::vector<ToolForces>& tools, ForceUnit forces, double unit) {
  const std::string title = std::string("Force, ") + forces.name;
  Chart chart{.x_title = "Depth, mm", .y_title = title, .x = {}, .y = {}, .rows = {}, .curves = {}};
  PlotRange depth;
  PlotRange force;
  const auto millimetres = [](const ForcePoint& point) { return 1e3 * point.depth; };
  for (std::size_t i = 0; i < tools.size(); ++i) {
    for (const ForcePoint& point : tools[i].points) {
      depth.include(millimetres(point));
      force.include(magnitude(point));
    }
    ChartCurve curve = curve_of(tools[i], millimetres, magnitude);
    curve.label = tools[i].tool;
    curve.color = kToolColors[i % std::size(kToolColors)];
    curve.line_width = 2.4 * unit;
    chart.curves.push_back(std::move(curve));
  }
  depth.widen();
  force.widen();
  chart.x = enclosing_axis(depth.lowest, depth.highest, 6);
  chart.y = enclosing_axis(force.lowest, 1.02 * force.highest, 8);
  return chart;
}

/// By which force_unit() takes the unit that shows `peak` well.
double expected_by(const Peak& peak) {
  return peak.force > 0 ? 10 * peak.force : 1;
}

/// The same with forces in `unit`.
std::vector<ToolForces> in_unit(std::vector<ToolForces> tools, ForceUnit unit) {
  for (ToolForces& tool : tools) {
    for (ForcePoint& point : tool.points) {
      for (double& component : point.force) component /= unit.newton;
    }
  }
  return tools;
}

std::string summary(const Peak& peak) {
  if (peak.force < 0) return "No forces were recorded.";
  return "Largest force " + force_quantity(peak.force, peak.force, expected_by(peak)).text() + " at " +
         fixed_text(peak.time, 2) + " s" + (peak.tool.empty() ? "" : " on " + peak.tool);
}

}  // namespace

Image force_plot_image(const std::string& title, const std::vector<ToolForces>& tools, ImageSize size) {
  const double unit = page_unit(size);
  const Peak peak = peak_of(tools);
  const ForceUnit forces = force_unit(expected_by(peak), peak.force);
  const std::vector<ToolForces> shown = in_unit(tools, forces);
  return plot_page({.title = title,
                    .summary = summary(peak),
                    .left = time_chart(shown, forces, unit),
                    .right = depth_chart(shown, forces, unit)},
                   size);
}

}  // namespace thinwall
