#include "renderer/annotation/ArrowShape.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {

void draw_arrow(const Canvas& canvas, PixelPoint tail, PixelPoint tip, double width, Color color) {
  const double length = std::hypot(tip[0] - tail[0], tip[1] - tail[1]);
  if (!(length > 0)) return;
  const PixelPoint along = {(tip[0] - tail[0]) / length, (tip[1] - tail[1]) / length};
  const double head = std::min(3.6 * width, length);
  const double half_head = head / 1.8;
  const double half = 0.5 * width * head / (3.6 * width);
  const auto go_to = [&](double forward, double aside, bool first) {
    const double x = tail[0] + forward * along[0] - aside * along[1];
    const double y = tail[1] + forward * along[1] + aside * along[0];
    (first ? cairo_move_to : cairo_line_to)(canvas.context(), x, y);
  };
  go_to(0, half, true);
  go_to(length - head, half, false);
  go_to(length - head, half_head, false);
  go_to(length, 0, false);
  go_to(length - head, -half_head, false);
  go_to(length - head, -half, false);
  go_to(0, -half, false);
  cairo_close_path(canvas.context());
  // Level lines that are drawn later come out otherwise under another join.
  cairo_save(canvas.context());
  cairo_set_line_join(canvas.context(), CAIRO_LINE_JOIN_ROUND);
  set_color(canvas.context(), {0.02, 0.03, 0.04, 0.75});
  cairo_set_line_width(canvas.context(), 0.5 * width);
  cairo_stroke_preserve(canvas.context());
  set_color(canvas.context(), color);
  cairo_fill(canvas.context());
  cairo_restore(canvas.context());
}

void draw_arrow_end_on(const Canvas& canvas, PixelPoint place, double width, bool towards_viewer, Color color) {
  constexpr Color kDark{0.02, 0.03, 0.04, 0.75};
  const auto [x, y] = place;
  const double radius = 1.5 * width, line = 0.5 * width;
  canvas.fill_circle(x, y, radius + line, kDark);
  canvas.fill_circle(x, y, radius + 0.5 * line, color);
  canvas.fill_circle(x, y, radius - 0.5 * line, kDark);
  if (towards_viewer) {
    canvas.fill_circle(x, y, 0.5 * radius, color);
    return;
  }
  const double arm = (radius - 0.5 * line) * std::sqrt(0.5);
  for (const double sense : {-1.0, 1.0}) canvas.line(x - arm, y - sense * arm, x + arm, y + sense * arm, line, color);
}

}  // namespace thinwall
