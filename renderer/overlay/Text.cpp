#include "renderer/overlay/Text.hpp"

#include <pango/pangocairo.h>

#include <cmath>

#include "renderer/overlay/Typesetting.hpp"

namespace thinwall {
namespace {

void set_font(PangoLayout* layout, const TextStyle& style) {
  PangoFontDescription* description = pango_font_description_new();
  pango_font_description_set_family(description, "Inter");
  pango_font_description_set_weight(description, style.bold ? PANGO_WEIGHT_SEMIBOLD : PANGO_WEIGHT_NORMAL);
  pango_font_description_set_absolute_size(description, style.size * PANGO_SCALE);
  pango_layout_set_font_description(layout, description);
  pango_font_description_free(description);
}

/// Digits of one width, so that a running number does not tremble.
void set_features(PangoLayout* layout, const TextStyle& style) {
  PangoAttrList* attributes = pango_attr_list_new();
  pango_attr_list_insert(attributes, pango_attr_font_features_new("tnum=1"));
  if (style.letter_spacing != 0) {
    const int spacing = static_cast<int>(std::lround(style.letter_spacing * PANGO_SCALE));
    pango_attr_list_insert(attributes, pango_attr_letter_spacing_new(spacing));
  }
  pango_layout_set_attributes(layout, attributes);
  pango_attr_list_unref(attributes);
}

void set_limits(PangoLayout* layout, const TextLimits& limits) {
  if (limits.width <= 0) return;
  pango_layout_set_width(layout, static_cast<int>(std::ceil(limits.width * PANGO_SCALE)));
  pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
  pango_layout_set_ellipsize(layout, PANGO_ELLIPSIZE_END);
  pango_layout_set_height(layout, -limits.lines);
}

/// Whether it belongs to a script that puts no spaces between words.
bool is_set_without_spaces(gunichar letter) {
  const GUnicodeScript script = g_unichar_get_script(letter);
  return g_unichar_iswide(letter) != FALSE || script == G_UNICODE_SCRIPT_THAI || script == G_UNICODE_SCRIPT_LAO ||
         script == G_UNICODE_SCRIPT_KHMER || script == G_UNICODE_SCRIPT_MYANMAR;
}

std::string valid_utf8(const std::string& text) {
  gchar* valid = g_utf8_make_valid(text.data(), static_cast<gssize>(text.size()));
  std::string result = valid;
  g_free(valid);
  return result;
}

}  // namespace

Text::Text(const std::string& text, const TextStyle& style, const TextLimits& limits)
    : layout_(pango_layout_new(overlay_font().context())), color_(style.color) {
  const std::string valid = typeset(valid_utf8(text));
  pango_layout_set_auto_dir(layout_.get(), FALSE);
  pango_layout_set_text(layout_.get(), valid.data(), static_cast<int>(valid.size()));
  set_font(layout_.get(), style);
  set_features(layout_.get(), style);
  set_limits(layout_.get(), limits);
  if (limits.alignment == TextAlignment::kCenter) pango_layout_set_alignment(layout_.get(), PANGO_ALIGN_CENTER);
  PangoRectangle logical;
  pango_layout_get_extents(layout_.get(), nullptr, &logical);
  width_ = static_cast<double>(logical.width) / PANGO_SCALE;
  height_ = static_cast<double>(logical.height) / PANGO_SCALE;
  ascent_ = static_cast<double>(pango_layout_get_baseline(layout_.get())) / PANGO_SCALE;
}

int Text::lines() const {
  return pango_layout_get_line_count(layout_.get());
}

bool Text::has_broken_word() const {
  const char* text = pango_layout_get_text(layout_.get());
  const PangoLogAttr* letters = pango_layout_get_log_attrs_readonly(layout_.get(), nullptr);
  for (int i = 1; i < lines(); ++i) {
    const char* start = text + pango_layout_get_line_readonly(layout_.get(), i)->start_index;
    if (start == text) continue;
    const gunichar before = g_utf8_get_char(g_utf8_prev_char(start));
    const bool may_end = letters[g_utf8_pointer_to_offset(text, start)].is_line_break != 0 &&
                         (is_set_without_spaces(before) || is_set_without_spaces(g_utf8_get_char(start)));
    if (g_unichar_isspace(before) == FALSE && !may_end) return true;
  }
  return false;
}

bool Text::is_cut() const {
  return pango_layout_is_ellipsized(layout_.get()) != FALSE;
}

int Text::unknown_letters() const {
  return pango_layout_get_unknown_glyphs_count(layout_.get());
}

// As outlines: cairo would place glyph pictures at whole pixels, which makes small text uneven.
void Text::draw(const Canvas& canvas, double x, double y) const {
  PangoRectangle logical;
  pango_layout_get_extents(layout_.get(), nullptr, &logical);
  cairo_move_to(canvas.context(), x - static_cast<double>(logical.x) / PANGO_SCALE, y);
  pango_cairo_layout_path(canvas.context(), layout_.get());
  set_color(canvas.context(), color_);
  cairo_fill(canvas.context());
}

}  // namespace thinwall
