#include "renderer/overlay/HalfCaptions.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/overlay/Font.hpp"
#include "renderer/overlay/Plate.hpp"
#include "renderer/overlay/Text.hpp"

namespace thinwall {
namespace {

constexpr double kTop = 80;  // units, below title and time
constexpr double kHeight = 38;
constexpr double kMarkLength = 22;
constexpr double kGap = 10;
constexpr double kPartOfHalf = 0.42;  // of a half's width, left of its middle
constexpr double kLeastPart = 100;    // units that it needs for a text
constexpr int kMostLines = 5;

/// Set in a part of the half's width, the more lines the longer it is; in all of it where the part is too narrow, as in
/// pictures that are higher than wide, which have room above the action, or where the text is too long for the part.
Text caption_text(const std::string& caption, const OverlayGrid& grid, double part, double whole) {
  const TextStyle style{.size = grid.pixels(19), .color = plate_style::kText};
  if (part >= grid.pixels(kLeastPart)) {
    Text beside(caption, style, {.width = part, .lines = kMostLines});
    if (!beside.is_cut()) return beside;
  }
  return {caption, style, {.width = whole, .lines = kMostLines}};
}

/// At the left of the half that begins at `left`: the action is in its middle.
void draw_caption(Image& image, const OverlayGrid& grid, const std::string& caption, const Color& color, int left,
                  const std::optional<Box>& inset) {
  const double padding = grid.pixels(plate_style::kPadding);
  const double mark = grid.pixels(kMarkLength + kGap);
  const double half = image.size.width / 2.0, taken = grid.pixels(plate_style::kMargin) + 2 * padding + mark;
  const double whole = half - taken - grid.pixels(plate_style::kMargin);
  if (whole < grid.pixels(20)) return;
  const Text text = caption_text(caption, grid, kPartOfHalf * half - taken, whole);
  const int height = std::max(grid.whole(kHeight), static_cast<int>(std::ceil(text.height() + grid.pixels(14))));
  const Plate plate(grid, {static_cast<int>(std::ceil(text.width() + mark + 2 * padding)), height});
  const double middle = plate.size().height / 2.0;
  plate.line(padding, middle, padding + grid.pixels(kMarkLength), middle, std::max(1.5, grid.pixels(3)), color);
  text.draw(plate, padding + mark, middle - text.height() / 2);
  const Box wanted{static_cast<double>(left + grid.whole(plate_style::kMargin)), static_cast<double>(grid.whole(kTop)),
                   static_cast<double>(plate.size().width), static_cast<double>(plate.size().height)};
  const double top = inset && wanted.overlaps(*inset) ? inset->bottom() + grid.pixels(kGap) : wanted.y;
  plate.blend_onto(image, static_cast<int>(wanted.x), static_cast<int>(std::lround(top)));
}

void draw_divider(Image& image) {
  constexpr std::uint8_t kLevel = 190;
  const int width = std::max(1, static_cast<int>(std::lround(2.0 * image.size.height / 720)));
  const int left = std::max(0, image.size.width - image.size.width / 2 - (width + 1) / 2);
  for (int row = 0; row < image.size.height; ++row) {
    const std::ptrdiff_t start = 3 * (static_cast<std::ptrdiff_t>(row) * image.size.width + left);
    std::fill_n(image.pixels.begin() + start, 3 * width, kLevel);
  }
}

}  // namespace

void draw_half_captions(Image& image, const std::array<std::string, 2>& captions, const std::optional<Box>& inset) {
  const FontUse use;
  const OverlayGrid grid(image.size);
  draw_divider(image);
  draw_caption(image, grid, captions[0], plate_style::kCurve, 0, inset);
  draw_caption(image, grid, captions[1], plate_style::kOtherCurve, image.size.width - image.size.width / 2, inset);
}

}  // namespace thinwall
