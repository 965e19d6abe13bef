#pragma once

#include <cairo.h>

#include "renderer/image/Image.hpp"
#include "renderer/overlay/Box.hpp"

namespace thinwall {

/// sRGB and opacity, 0 to 1.
struct Color {
  double red = 0;
  double green = 0;
  double blue = 0;
  double opacity = 1;
  Color with_opacity(double value) const { return {red, green, blue, value}; }
};

/// A transparent surface to draw on with cairo, on the processor.
class Canvas {
 public:
  /// Throws PictureFailure when there is no memory.
  explicit Canvas(ImageSize size);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  cairo_t* context() const { return context_; }
  ImageSize size() const { return size_; }

  void fill(Color color) const;
  void fill_rounded(const Box& box, double radius, Color color) const;
  void stroke_rounded(const Box& box, double radius, double line_width, Color color) const;
  void fill_circle(double x, double y, double radius, Color color) const;
  void line(double from_x, double from_y, double to_x, double to_y, double line_width, Color color) const;

  /// Lays the surface over the picture with its top left at (left, top); what lies outside is cut off.
  void blend_onto(Image& image, int left, int top) const;

 private:
  ImageSize size_;
  cairo_surface_t* surface_ = nullptr;
  cairo_t* context_ = nullptr;
};

void set_color(cairo_t* context, Color color);

}  // namespace thinwall
