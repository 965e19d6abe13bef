#include "renderer/overlay/GaugePlate.hpp"

#include <algorithm>

#include "renderer/overlay/NumberText.hpp"
#include "renderer/overlay/PhaseStyle.hpp"
#include "renderer/overlay/Text.hpp"

namespace thinwall {
namespace {

using plate_style::kPadding;
using plate_style::kSmallText;

/// The phase as a coloured word in a pill at the right; gives its left edge.
double draw_phase(const Plate& plate, const OverlayGrid& grid, const std::string& phase) {
  const double right = plate.size().width - grid.pixels(kPadding);
  if (phase.empty()) return right;
  const Color color = phase_color(phase);
  const Text text(phase_label(phase), {.size = grid.pixels(kSmallText), .bold = true, .color = color},
                  {.width = grid.pixels(110)});
  const double width = text.width() + grid.pixels(20);
  const Box pill{right - width, grid.pixels(10), width, grid.pixels(24)};
  plate.fill_rounded(pill, pill.height / 2, color.with_opacity(0.18));
  text.draw(plate, pill.x + grid.pixels(10), pill.y + (pill.height - text.height()) / 2);
  return pill.x;
}

void draw_force(const Plate& plate, const OverlayGrid& grid, const QuantityText& force) {
  const double baseline = grid.pixels(77);
  const double room = plate.size().width - grid.pixels(2 * kPadding + 40);
  TextStyle style{.size = grid.pixels(42), .bold = true, .color = plate_style::kText};
  const double width = Text(force.number, style).width();
  if (width > room) style.size *= room / width;
  style.letter_spacing = -0.02 * style.size;  // the font is drawn for small text
  const Text number(force.number, style);
  number.draw_on_baseline(plate, grid.pixels(kPadding - 1), baseline);
  Text(force.unit, {.size = grid.pixels(20), .color = plate_style::kFaintText})
      .draw_on_baseline(plate, grid.pixels(kPadding + 6) + number.width(), baseline);
}

constexpr double kSmallestName = 0.75;  // of small text, so that it can still be read

void draw_value(const Plate& plate, const OverlayGrid& grid, double x, double room, const std::string& name,
                const QuantityText& value) {
  TextStyle style{.size = grid.pixels(kSmallText), .color = plate_style::kFaintText};
  const double width = Text(name, style).width();
  if (width > room) style.size *= std::max(kSmallestName, room / width);
  Text(name, style, {.width = room}).draw_on_baseline(plate, x, grid.pixels(110));
  Text(value.text(), {.size = grid.pixels(19), .color = plate_style::kText}, {.width = room})
      .draw_on_baseline(plate, x, grid.pixels(133));
}

}  // namespace

void draw_gauge(Image& image, const OverlayGrid& grid, const OverlayContent& content, double peak) {
  const Plate plate(grid, {grid.whole(plate_style::kGaugeWidth), grid.whole(plate_style::kPanelHeight)});
  const double left = grid.pixels(kPadding);
  const double phase_left = draw_phase(plate, grid, content.phase);
  const double room = phase_left - left - grid.pixels(10);
  const Text tool(content.tool, {.size = grid.pixels(kSmallText + 1), .color = plate_style::kFaintText},
                  {.width = std::max(1.0, room)});
  tool.draw(plate, left, grid.pixels(22) - tool.height() / 2);
  draw_force(plate, grid, force_quantity(content.force, peak, content.expected_force));
  const double line = grid.pixels(90);
  plate.line(left, line, plate.size().width - left, line, std::max(1.0, grid.unit), plate_style::kGridLine);
  const std::string& body = content.pressurized_body;
  // A body's name takes what the depth leaves.
  const double middle = body.empty() ? plate.size().width / 2.0 : left + grid.pixels(97);
  draw_value(plate, grid, left, middle - left, "Depth", depth_quantity(content.depth));
  if (content.pressure) {
    const std::string name = body.empty() ? "Pressure" : "Pressure, " + body;
    draw_value(plate, grid, middle, plate.size().width - left - middle, name, pressure_quantity(*content.pressure));
  }
  const int margin = grid.whole(plate_style::kMargin);
  plate.blend_onto(image, margin, image.size.height - margin - plate.size().height);
}

}  // namespace thinwall
