#include "renderer/metric/PixelTolerance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "renderer/image/ImageDifference.hpp"

namespace thinwall {
namespace {

std::size_t pixel_count(ImageSize size) {
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

const std::uint8_t* pixel_at(const Image& image, int x, int y) {
  return &image.pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.width) +
                            static_cast<std::size_t>(x))];
}

bool is_close(const std::uint8_t* a, const std::uint8_t* b, int level) {
  return std::abs(a[0] - b[0]) <= level && std::abs(a[1] - b[1]) <= level && std::abs(a[2] - b[2]) <= level;
}

/// Whether `other` shows near (x, y) what `image` shows there.
bool is_found(const Image& image, const Image& other, int x, int y, const PixelTolerance& tolerance) {
  const std::uint8_t* wanted = pixel_at(image, x, y);
  const int shift = tolerance.shift;
  for (int row = std::max(0, y - shift); row <= std::min(image.size.height - 1, y + shift); ++row) {
    for (int column = std::max(0, x - shift); column <= std::min(image.size.width - 1, x + shift); ++column) {
      if (is_close(wanted, pixel_at(other, column, row), tolerance.level)) return true;
    }
  }
  return false;
}

}  // namespace

FailingPixels failing_pixels(const Image& first, const Image& second, const PixelTolerance& tolerance,
                             const std::vector<std::uint8_t>& mask) {
  assert(first.size == second.size && (mask.empty() || mask.size() == pixel_count(first.size)));
  FailingPixels result;
  result.where.assign(pixel_count(first.size), 0);
  std::size_t index = 0;
  for (int y = 0; y < first.size.height; ++y) {
    if (mask.empty() && !row_differs(first, second, y)) {
      result.counted += first.size.width;
      index += static_cast<std::size_t>(first.size.width);
      continue;
    }
    for (int x = 0; x < first.size.width; ++x, ++index) {
      if (!mask.empty() && mask[index] == 0) continue;
      ++result.counted;
      if (is_close(pixel_at(first, x, y), pixel_at(second, x, y), tolerance.level)) continue;
      const bool passes =
          tolerance.shift > 0 && is_found(first, second, x, y, tolerance) && is_found(second, first, x, y, tolerance);
      if (passes) continue;
      ++result.failing;
      result.where[index] = 1;
    }
  }
  return result;
}

std::vector<std::uint8_t> mask_of(const Image& image) {
  std::vector<std::uint8_t> mask(pixel_count(image.size));
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = image.pixels[3 * i + 1] >= 128 ? 1 : 0;
  return mask;
}

Image with_masked_pixels_of(const Image& second, const Image& first, const std::vector<std::uint8_t>& mask) {
  assert(first.size == second.size && mask.size() == pixel_count(first.size));
  Image result = second;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) std::copy_n(&first.pixels[3 * i], 3, &result.pixels[3 * i]);
  }
  return result;
}

}  // namespace thinwall
