#include "renderer/overlay/PlotPage.hpp"

#include <algorithm>

#include "renderer/overlay/Font.hpp"
#include "renderer/overlay/PhaseStyle.hpp"
#include "renderer/overlay/Text.hpp"

namespace thinwall {

void PlotRange::include(double value) {
  lowest = std::min(lowest, value);
  highest = std::max(highest, value);
}

void PlotRange::widen() {
  if (highest - lowest < 1e-9) highest = lowest + 1;
}

double page_unit(ImageSize size) {
  return std::min(size.width / 1600.0, size.height / 900.0);
}

Image plot_page(const PlotPage& page, ImageSize size) {
  const FontUse use;
  const double unit = page_unit(size);
  const double margin = 48 * unit;
  const Canvas canvas(size);
  const double text_width = size.width - 2 * margin;
  Text(page.title, {.size = 28 * unit, .bold = true, .color = kPageInk}, {.width = text_width})
      .draw(canvas, margin, 34 * unit);
  Text(page.summary, {.size = 17 * unit, .color = kFaintPageInk}, {.width = text_width})
      .draw(canvas, margin, 74 * unit);
  const double top = 122 * unit;
  const double height = size.height - top - 36 * unit;
  const double left_width = 0.62 * (size.width - 2 * margin);
  const double right = margin + left_width + 56 * unit;
  draw_chart(canvas, {margin, top, left_width, height}, unit, page.left);
  draw_chart(canvas, {right, top, size.width - margin - right, height}, unit, page.right);
  Image image{.size = size, .pixels = {}};
  image.pixels.assign(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 3, 255);
  canvas.blend_onto(image, 0, 0);
  return image;
}

ChartBandRow phase_row(const ToolForces& tool, const std::string& name) {
  ChartBandRow row{.name = name, .bands = {}};
  for (const ForcePoint& point : tool.points) {
    if (!row.bands.empty()) row.bands.back().end = point.time;
    const std::string label = phase_label(point.phase);
    if (row.bands.empty() || row.bands.back().label != label) {
      row.bands.push_back({point.time, point.time, label, phase_color(point.phase)});
    }
  }
  return row;
}

}  // namespace thinwall
