#pragma once

#include <pango/pango.h>

#include <memory>
#include <string>

#include "renderer/overlay/Canvas.hpp"
#include "renderer/overlay/Font.hpp"

namespace thinwall {

struct TextStyle {
  double size = 16;  // pixels, of the em
  bool bold = false;
  Color color = {1, 1, 1};
  double letter_spacing = 0;  // pixels, added between letters
};

enum class TextAlignment { kLeft, kCenter };

/// A limit of zero is none.
struct TextLimits {
  double width = 0;  // pixels; longer text wraps, where lines allow, else it is cut with an ellipsis
  int lines = 1;     // more are cut with an ellipsis
  TextAlignment alignment = TextAlignment::kLeft;
};

/// Text laid out in the pinned font, digits all of one width. Bytes that are no UTF-8 are shown as a replacement sign.
class Text {
 public:
  Text(const std::string& text, const TextStyle& style, const TextLimits& limits = {});

  double width() const { return width_; }    // pixels
  double height() const { return height_; }  // pixels, of whole lines
  int lines() const;
  bool has_broken_word() const;  // whether a line ends inside a word
  bool is_cut() const;           // whether an ellipsis stands for a part
  int unknown_letters() const;   // how many the font has no shape for, which boxes with their numbers stand for

  /// With its top left at the place.
  void draw(const Canvas& canvas, double x, double y) const;
  /// With its first baseline at y.
  void draw_on_baseline(const Canvas& canvas, double x, double y) const { draw(canvas, x, y - ascent_); }

 private:
  std::unique_ptr<PangoLayout, ReleaseObject> layout_;
  Color color_;
  double width_ = 0;
  double height_ = 0;
  double ascent_ = 0;  // pixels from the top to the first baseline
};

}  // namespace thinwall
