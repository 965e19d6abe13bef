#include "renderer/camera/PictureLayout.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/image/OverlayUnit.hpp"

namespace thinwall {
namespace {

constexpr std::uint8_t kLineLevel = 190;

/// As the overlays' plates are measured.
int pixels(double units, ImageSize size) {
  return static_cast<int>(std::lround(units * overlay_unit(size)));
}

void fill(const PictureBox& box, Image& image) {
  for (int row = box.top; row < box.top + box.size.height; ++row) {
    const std::ptrdiff_t start = 3 * (static_cast<std::ptrdiff_t>(row) * image.size.width + box.left);
    std::fill_n(image.pixels.begin() + start, 3 * box.size.width, kLineLevel);
  }
}

}  // namespace

PictureBox main_box(const Shot& shot, ImageSize size) {
  if (!shot.beside) return {.size = size};
  return {.size = {size.width - size.width / 2, size.height}};
}

PictureBox beside_box(ImageSize size) {
  return {.left = size.width - size.width / 2, .top = 0, .size = {size.width / 2, size.height}};
}

PictureBox inset_box(const Shot& shot, ImageSize size) {
  constexpr double kPart = 0.3;
  constexpr double kMargin = 26, kAboveIt = 52, kBelowIt = 184;  // units: title or time, and panels
  const double part = shot.beside ? kPart / 2 : kPart;
  const ImageSize small{std::max(1, static_cast<int>(part * size.width)),
                        std::max(1, static_cast<int>(part * size.height))};
  const int margin = pixels(kMargin, size);
  const int left = is_left(shot.corner) ? margin : size.width - margin - small.width;
  const int top = is_upper(shot.corner) ? margin + pixels(kAboveIt, size)
                                        : size.height - margin - pixels(kBelowIt, size) - small.height;
  return {.left = std::max(0, left), .top = std::max(0, top), .size = small};
}

void paste(const Image& part, const PictureBox& box, Image& onto) {
  assert(part.size == box.size);
  for (int row = 0; row < box.size.height; ++row) {
    const auto* from = part.pixels.data() + 3 * static_cast<std::ptrdiff_t>(row) * part.size.width;
    auto* to = onto.pixels.data() + 3 * (static_cast<std::ptrdiff_t>(box.top + row) * onto.size.width + box.left);
    std::copy_n(from, 3 * box.size.width, to);
  }
}

void frame_box(const PictureBox& box, Image& image) {
  const int line = std::min({std::max(1, pixels(2, image.size)), box.size.width, box.size.height});
  const auto [width, height] = box.size;
  fill({box.left, box.top, {width, line}}, image);
  fill({box.left, box.top + height - line, {width, line}}, image);
  fill({box.left, box.top, {line, height}}, image);
  fill({box.left + width - line, box.top, {line, height}}, image);
}

}  // namespace thinwall
