#include "renderer/overlay/TextPlates.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/overlay/NumberText.hpp"
#include "renderer/overlay/Text.hpp"

namespace thinwall {
namespace {

constexpr double kTitleSize = 20;
constexpr double kTitlePlateHeight = 40;

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

void draw_title(Image& image, const OverlayGrid& grid, const std::string& title, int right) {
  const double padding = grid.pixels(plate_style::kPadding);
  const int left = grid.whole(plate_style::kMargin);
  const double room = right - left - 2 * padding;
  if (room < grid.pixels(kTitleSize)) return;
  const Text text(title, {.size = grid.pixels(kTitleSize), .bold = true, .color = plate_style::kText}, {.width = room});
  const Plate plate(grid, {static_cast<int>(std::ceil(text.width() + 2 * padding)), grid.whole(kTitlePlateHeight)});
  text.draw(plate, padding, (plate.size().height - text.height()) / 2);
  plate.blend_onto(image, left, grid.whole(plate_style::kMargin));
}

void draw_caption(Image& image, const OverlayGrid& grid, const std::string& caption, const CaptionSpace& space) {
  constexpr double kSizes[] = {22, 20, 18, 16, 14};
  constexpr double kLineHeight = 1.25;  // of the size; Inter's own is 1.21
  const double padding_x = grid.pixels(20);
  const double padding_y = grid.pixels(11);
  const double room = space.width - 2 * padding_x;
  if (room < grid.pixels(kSizes[0])) return;
  for (const double size : kSizes) {
    const double line = grid.pixels(size) * kLineHeight;
    const int lines = std::max(1, static_cast<int>((space.height - 2 * padding_y) / line));
    const Text text(caption, {.size = grid.pixels(size), .color = plate_style::kText},
                    {.width = room, .lines = lines, .alignment = TextAlignment::kCenter});
    if (text.is_cut() && size != std::end(kSizes)[-1]) continue;
    const Plate plate(grid, {static_cast<int>(std::ceil(text.width() + 2 * padding_x)),
                             static_cast<int>(std::ceil(text.height() + 2 * padding_y))});
    text.draw(plate, padding_x, padding_y);
    plate.blend_onto(image, space.center - plate.size().width / 2, space.bottom - plate.size().height);
    return;
  }
}

}  // namespace thinwall
