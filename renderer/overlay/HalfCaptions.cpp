#include "renderer/overlay/HalfCaptions.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/overlay/Font.hpp"
#include "renderer/overlay/Plate.hpp"
#include "renderer/overlay/Text.hpp"

namespace thinwall {
namespace {

constexpr double kHalfCaptionTop = 80;  // units, below title and time
constexpr double kHalfCaptionHeight = 38;
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

/// A caption as it is set, and where its plate is.
struct SetCaption {
  Text text;
  Box plate;
};

double mark_width(const OverlayGrid& grid) {
  return grid.pixels(kMarkLength + kGap);
}

/// At the left of the half that begins at `left`: the action is in its middle. None without room.
std::optional<SetCaption> set_caption(ImageSize size, const std::string& caption, int left,
                                      const std::optional<Box>& inset) {
  const OverlayGrid grid(size);
  const double padding = grid.pixels(plate_style::kPadding), mark = mark_width(grid);
  const double half = size.width / 2.0, taken = grid.pixels(plate_style::kMargin) + 2 * padding + mark;
  const double whole = half - taken - grid.pixels(plate_style::kMargin);
  if (whole < grid.pixels(20)) return std::nullopt;
  Text text = caption_text(caption, grid, kPartOfHalf * half - taken, whole);
  Box plate{static_cast<double>(left + grid.whole(plate_style::kMargin)),
            static_cast<double>(grid.whole(kHalfCaptionTop)), std::ceil(text.width() + mark + 2 * padding),
            std::max<double>(grid.whole(kHalfCaptionHeight), std::ceil(text.height() + grid.pixels(14)))};
  if (inset && plate.overlaps(*inset)) plate.y = inset->bottom() + grid.pixels(kGap);
  return SetCaption{std::move(text), plate};
}

int left_of_half(ImageSize size, std::size_t half) {
  return half == 0 ? 0 : size.width - size.width / 2;
}

void draw_caption(Image& image, const SetCaption& caption, const Color& color) {
  const OverlayGrid grid(image.size);
  const double padding = grid.pixels(plate_style::kPadding);
  const Plate plate(grid, {static_cast<int>(caption.plate.width), static_cast<int>(caption.plate.height)});
  const double middle = plate.size().height / 2.0;
  plate.line(padding, middle, padding + grid.pixels(kMarkLength), middle, std::max(1.5, grid.pixels(3)), color);
  caption.text.draw(plate, padding + mark_width(grid), middle - caption.text.height() / 2);
  plate.blend_onto(image, static_cast<int>(caption.plate.x), static_cast<int>(std::lround(caption.plate.y)));
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
  draw_divider(image);
  for (std::size_t half = 0; half < captions.size(); ++half) {
    const auto caption = set_caption(image.size, captions[half], left_of_half(image.size, half), inset);
    if (caption) draw_caption(image, *caption, half == 0 ? plate_style::kCurve : plate_style::kOtherCurve);
  }
}

std::vector<Box> half_caption_places(ImageSize size, const std::array<std::string, 2>& captions,
                                     const std::optional<Box>& inset) {
  const FontUse use;
  std::vector<Box> places;
  for (std::size_t half = 0; half < captions.size(); ++half) {
    if (captions[half].empty()) continue;
    const auto caption = set_caption(size, captions[half], left_of_half(size, half), inset);
    if (caption) places.push_back(caption->plate);
  }
  return places;
}

}  // namespace thinwall
