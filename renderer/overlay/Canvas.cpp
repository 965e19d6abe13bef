#include "renderer/overlay/Canvas.hpp"

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <string>

#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

void round_path(cairo_t* context, const Box& box, double radius) {
  constexpr double kQuarter = std::numbers::pi / 2;
  const double r = std::min({radius, box.width / 2, box.height / 2});
  cairo_new_sub_path(context);
  cairo_arc(context, box.right() - r, box.y + r, r, -kQuarter, 0);
  cairo_arc(context, box.right() - r, box.bottom() - r, r, 0, kQuarter);
  cairo_arc(context, box.x + r, box.bottom() - r, r, kQuarter, 2 * kQuarter);
  cairo_arc(context, box.x + r, box.y + r, r, 2 * kQuarter, 3 * kQuarter);
  cairo_close_path(context);
}

/// The level below a layer of given opacity, rounded to nearest.
unsigned dimmed(unsigned level, unsigned opacity) {
  return (level * (255 - opacity) + 127) / 255;
}

}  // namespace

void set_color(cairo_t* context, Color color) {
  cairo_set_source_rgba(context, color.red, color.green, color.blue, color.opacity);
}

Canvas::Canvas(ImageSize size)
    : size_(size),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, size.width, size.height)),
      context_(cairo_create(surface_)) {
  if (cairo_status(context_) == CAIRO_STATUS_SUCCESS) return;
  const std::string reason = cairo_status_to_string(cairo_status(context_));
  cairo_destroy(context_);
  cairo_surface_destroy(surface_);
  throw PictureFailure("cannot draw an overlay of " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                       " pixels: " + reason);
}

Canvas::~Canvas() {
  cairo_destroy(context_);
  cairo_surface_destroy(surface_);
}

void Canvas::fill(Color color) const {
  set_color(context_, color);
  cairo_paint(context_);
}

void Canvas::fill_rounded(const Box& box, double radius, Color color) const {
  round_path(context_, box, radius);
  set_color(context_, color);
  cairo_fill(context_);
}

void Canvas::stroke_rounded(const Box& box, double radius, double line_width, Color color) const {
  round_path(context_, box, radius);
  set_color(context_, color);
  cairo_set_line_width(context_, line_width);
  cairo_stroke(context_);
}

void Canvas::fill_circle(double x, double y, double radius, Color color) const {
  cairo_arc(context_, x, y, radius, 0, 2 * std::numbers::pi);
  set_color(context_, color);
  cairo_fill(context_);
}

void Canvas::line(double from_x, double from_y, double to_x, double to_y, double line_width, Color color) const {
  cairo_move_to(context_, from_x, from_y);
  cairo_line_to(context_, to_x, to_y);
  set_color(context_, color);
  cairo_set_line_width(context_, line_width);
  cairo_stroke(context_);
}

void Canvas::blend_onto(Image& image, int left, int top) const {
  cairo_surface_flush(surface_);
  const std::uint8_t* data = cairo_image_surface_get_data(surface_);
  const std::ptrdiff_t stride = cairo_image_surface_get_stride(surface_);
  const int first_column = std::max(0, -left);
  const int last_column = std::min(size_.width, image.size.width - left);
  for (int row = std::max(0, -top); row < std::min(size_.height, image.size.height - top); ++row) {
    const auto* source = reinterpret_cast<const std::uint32_t*>(data + row * stride);
    const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(top + row) * image.size.width + left;
    std::uint8_t* target = image.pixels.data() + 3 * (start + first_column);
    for (int column = first_column; column < last_column; ++column, target += 3) {
      const std::uint32_t pixel = source[column];
      const unsigned opacity = pixel >> 24;
      if (opacity == 0) continue;
      // cairo's colours are multiplied by the opacity already.
      target[0] = static_cast<std::uint8_t>(((pixel >> 16) & 255) + dimmed(target[0], opacity));
      target[1] = static_cast<std::uint8_t>(((pixel >> 8) & 255) + dimmed(target[1], opacity));
      target[2] = static_cast<std::uint8_t>((pixel & 255) + dimmed(target[2], opacity));
    }
  }
}

}  // namespace thinwall
