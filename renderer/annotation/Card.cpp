#include "renderer/annotation/Card.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "renderer/overlay/Font.hpp"
#include "renderer/overlay/Plate.hpp"
#include "renderer/overlay/Text.hpp"

namespace thinwall {

namespace {

/// The part `share` of `other` in place of as much of the image.
void mix_in(Image& image, const Image& other, double share) {
  assert(image.pixels.size() == other.pixels.size());
  const int weight = static_cast<int>(std::lround(256 * share));
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] =
        static_cast<std::uint8_t>((image.pixels[i] * (256 - weight) + other.pixels[i] * weight + 128) >> 8);
  }
}

}  // namespace

void draw_card(Image& image, const Image& bare, const Card& card) {
  if (card.opacity <= 0) return;
  mix_in(image, bare, std::min(1.0, card.opacity));
  const FontUse use;
  const OverlayGrid grid(image.size);
  const double opacity = std::min(1.0, card.opacity);
  const double width = 0.8 * image.size.width;
  const Text title(card.title,
                   {.size = grid.pixels(46), .bold = true, .color = plate_style::kText.with_opacity(opacity)},
                   {.width = width, .lines = 3, .alignment = TextAlignment::kCenter});
  const Text text(card.text, {.size = grid.pixels(24), .color = plate_style::kFaintText.with_opacity(opacity)},
                  {.width = width, .lines = 6, .alignment = TextAlignment::kCenter});
  const double between = card.text.empty() ? 0 : grid.pixels(40);
  const double height = title.height() + between + (card.text.empty() ? 0 : text.height());
  const Canvas canvas(image.size);
  canvas.fill({0.02, 0.03, 0.04, 0.84 * opacity});
  const double top = 0.5 * (image.size.height - height);
  title.draw(canvas, 0.5 * (image.size.width - title.width()), top);
  if (!card.text.empty()) {
    const double middle = top + title.height() + 0.5 * between;
    const double half = grid.pixels(36);
    canvas.line(0.5 * image.size.width - half, middle, 0.5 * image.size.width + half, middle,
                std::max(1.0, grid.pixels(2)), plate_style::kCurve.with_opacity(opacity));
    text.draw(canvas, 0.5 * (image.size.width - text.width()), top + title.height() + between);
  }
  canvas.blend_onto(image, 0, 0);
}

}  // namespace thinwall
