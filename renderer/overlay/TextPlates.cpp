#include "renderer/overlay/TextPlates.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "renderer/overlay/NumberText.hpp"
#include "renderer/overlay/Text.hpp"

namespace thinwall {
namespace {

constexpr double kTitleSize = 20;
constexpr double kTitlePlateHeight = 40;

struct TextPlate {
  std::unique_ptr<Plate> plate = {};
  bool is_cut = false;  // whether an ellipsis stands for a part of the text
};

/// A plate stays the same over many frames; drawing it again would cost more than all else. What it shows follows from
/// the key alone.
struct RememberedPlate {
  std::string text;
  double unit = 0;
  double width = 0;
  double height = 0;
  TextPlate made;

  template <typename Make>
  const TextPlate& get(const std::string& new_text, double new_unit, double new_width, double new_height, Make make) {
    if (!made.plate || text != new_text || unit != new_unit || width != new_width || height != new_height) {
      made = make();
      text = new_text;
      unit = new_unit;
      width = new_width;
      height = new_height;
    }
    return made;
  }
};

/// The narrowest width that needs no more lines than `room`: lines of about the same length read best.
double balanced_width(const std::string& caption, const TextStyle& style, TextLimits limits) {
  const int lines = Text(caption, style, limits).lines();
  if (lines == 1) return limits.width;
  double narrow = limits.width / 2;
  double wide = limits.width;
  while (wide - narrow > style.size / 2) {
    limits.width = (narrow + wide) / 2;
    const Text text(caption, style, limits);
    (text.lines() > lines || text.is_cut() || text.has_broken_word() ? narrow : wide) = limits.width;
  }
  return wide;
}

/// In the largest letters in which nothing is cut, at worst the smallest: the plate has the height of two lines of
/// them.
Text title_text(const OverlayGrid& grid, const std::string& title, double room) {
  constexpr double kSizes[] = {kTitleSize, 17, 14};
  constexpr int kLines[] = {1, 1, 2};
  for (std::size_t i = 0;; ++i) {
    const TextStyle style{.size = grid.pixels(kSizes[i]), .bold = true, .color = plate_style::kText};
    TextLimits limits{.width = room, .lines = kLines[i]};
    const bool is_cut = Text(title, style, limits).is_cut();
    if (is_cut && i + 1 < std::size(kSizes)) continue;
    if (!is_cut) limits.width = balanced_width(title, style, limits);
    return {title, style, limits};
  }
}

TextPlate title_plate(const OverlayGrid& grid, const std::string& title, double room) {
  const double padding = grid.pixels(plate_style::kPadding);
  const Text text = title_text(grid, title, room);
  const ImageSize size{static_cast<int>(std::ceil(text.width() + 2 * padding)), grid.whole(kTitlePlateHeight)};
  auto plate = std::make_unique<Plate>(grid, size);
  text.draw(*plate, padding, (size.height - text.height()) / 2);
  return {std::move(plate), text.is_cut()};
}

/// `room` is for the text. Takes the largest size in which nothing is cut, at worst the smallest.
TextPlate caption_plate(const OverlayGrid& grid, const std::string& caption, const ImageSize& room) {
  constexpr double kSizes[] = {22, 20, 18, 16, 14};
  constexpr double kLineHeight = 1.25;  // of the size; Inter's own is 1.21
  constexpr int kMostLines[] = {3, 4, 4, 8, 8};
  const double padding_x = grid.pixels(20);
  const double padding_y = grid.pixels(11);
  for (std::size_t i = 0;; ++i) {
    const TextStyle style{.size = grid.pixels(kSizes[i]), .color = plate_style::kText};
    const int lines = std::clamp(static_cast<int>(room.height / (style.size * kLineHeight)), 1, kMostLines[i]);
    TextLimits limits{.width = static_cast<double>(room.width), .lines = lines, .alignment = TextAlignment::kCenter};
    const bool is_cut = Text(caption, style, limits).is_cut();
    if (is_cut && i + 1 < std::size(kSizes)) continue;
    if (!is_cut) limits.width = balanced_width(caption, style, limits);
    const Text text(caption, style, limits);
    auto plate = std::make_unique<Plate>(grid, ImageSize{static_cast<int>(std::ceil(text.width() + 2 * padding_x)),
                                                         static_cast<int>(std::ceil(text.height() + 2 * padding_y))});
    text.draw(*plate, padding_x, padding_y);
    return {std::move(plate), is_cut};
  }
}

Text badge_text(const OverlayGrid& grid, const std::string& words) {
  return {words, {.size = grid.pixels(15), .bold = true, .color = plate_style::kCurve}};
}

int badge_width(const OverlayGrid& grid, const Text& text) {
  return static_cast<int>(std::ceil(text.width() + 2 * grid.pixels(plate_style::kPadding)));
}

/// At one place while times are short.
int badge_left(const OverlayGrid& grid, int width, int right) {
  return std::min(grid.size.width - grid.whole(plate_style::kMargin) - grid.whole(122), right) - width;
}

}  // namespace

int draw_time(Image& image, const OverlayGrid& grid, double time, double duration) {
  const TextStyle style{.size = grid.pixels(kTitleSize), .bold = true, .color = plate_style::kText};
  const auto text_of = [](double value) { return fixed_text(value, 2) + " s"; };
  const Text text(text_of(time), style);
  // As wide as the longest time to come, so that the plate stands still.
  const double width = std::max(text.width(), Text(text_of(std::max(time, duration)), style).width());
  const double padding = grid.pixels(plate_style::kPadding);
  const Plate plate(grid, {static_cast<int>(std::ceil(width + 2 * padding)), grid.whole(kTitlePlateHeight)});
  text.draw(plate, plate.size().width - padding - text.width(), (plate.size().height - text.height()) / 2);
  const int left = image.size.width - grid.whole(plate_style::kMargin) - plate.size().width;
  plate.blend_onto(image, left, grid.whole(plate_style::kMargin));
  return left;
}

int left_of_badge(const OverlayGrid& grid, const std::string& words, int right) {
  return badge_left(grid, badge_width(grid, badge_text(grid, words)), right);
}

int draw_badge(Image& image, const OverlayGrid& grid, const std::string& words, int right) {
  const Text text = badge_text(grid, words);
  const Plate plate(grid, {badge_width(grid, text), grid.whole(32)});
  text.draw(plate, grid.pixels(plate_style::kPadding), 0.5 * (plate.size().height - text.height()));
  const int left = badge_left(grid, plate.size().width, right);
  plate.blend_onto(image, left, grid.whole(plate_style::kMargin) + grid.whole(4));
  return left;
}

bool draw_title(Image& image, const OverlayGrid& grid, const std::string& title, int right) {
  thread_local RememberedPlate memory;
  const int left = grid.whole(plate_style::kMargin);
  const double room = right - left - 2 * grid.pixels(plate_style::kPadding);
  if (room < grid.pixels(kTitleSize)) return true;
  const auto& [plate, is_cut] = memory.get(title, grid.unit, room, 0, [&] { return title_plate(grid, title, room); });
  plate->blend_onto(image, left, grid.whole(plate_style::kMargin));
  return is_cut;
}

bool draw_caption(Image& image, const OverlayGrid& grid, const std::string& caption, const CaptionSpace& space) {
  thread_local RememberedPlate memory;
  const ImageSize room{space.width - 2 * grid.whole(20), space.height - 2 * grid.whole(11)};
  if (room.width < grid.pixels(22) || room.height < grid.pixels(22)) return true;
  const auto& [plate, is_cut] =
      memory.get(caption, grid.unit, room.width, room.height, [&] { return caption_plate(grid, caption, room); });
  plate->blend_onto(image, space.center - plate->size().width / 2, space.bottom - plate->size().height);
  return is_cut;
}

}  // namespace thinwall
