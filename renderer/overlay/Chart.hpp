#pragma once

#include <string>
#include <vector>

#include "renderer/overlay/Axis.hpp"
#include "renderer/overlay/Canvas.hpp"
#include "renderer/overlay/ForceCurve.hpp"

namespace thinwall {

struct ChartCurve {
  std::string label;  // empty: not in the legend
  Color color;
  double line_width = 2;       // pixels
  std::vector<double> dashes;  // pixels drawn, pixels left out, ...; empty: a whole line
  std::vector<PlotPoint> points;
};

/// A coloured stretch of the x axis, shown as a band, with its word in a row above the chart.
struct ChartBand {
  double begin = 0;
  double end = 0;
  std::string label;
  Color color;
};

/// Bands of one row share its place above the chart; only the first row's reach down into it.
struct ChartBandRow {
  std::string name;  // left of the row; empty: none
  std::vector<ChartBand> bands;
};

/// A chart for paper: white ground, x to the right, y upwards.
struct Chart {
  std::string x_title;  // with unit
  std::string y_title;  // with unit
  Axis x;
  Axis y;
  std::vector<ChartBandRow> rows;
  std::vector<ChartCurve> curves;
};

/// Draws the chart with its titles, legend and bands into `box`. `unit` is the length in pixels that text (15 units)
/// and gaps scale with.
void draw_chart(const Canvas& canvas, const Box& box, double unit, const Chart& chart);

}  // namespace thinwall
