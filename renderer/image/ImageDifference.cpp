#include "renderer/image/ImageDifference.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace thinwall {
namespace {

constexpr std::size_t kWorstCount = 10;

inline int pixel_difference(const std::uint8_t* a, const std::uint8_t* b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

const std::uint8_t* row_of(const Image& image, int row) {
  return &image.pixels[3 * static_cast<std::size_t>(row) * static_cast<std::size_t>(image.size.width)];
}

std::size_t pixel_count(const Image& image) {
  return static_cast<std::size_t>(image.size.width) * static_cast<std::size_t>(image.size.height);
}

/// Keeps `worst` sorted; pixels come in reading order, so equal ones stay in it.
void keep_if_worst(std::vector<PixelDifference>& worst, const PixelDifference& pixel) {
  if (worst.size() == kWorstCount && pixel.difference <= worst.back().difference) return;
  const auto place = std::upper_bound(worst.begin(), worst.end(), pixel,
                                      [](const auto& a, const auto& b) { return a.difference > b.difference; });
  worst.insert(place, pixel);
  if (worst.size() > kWorstCount) worst.pop_back();
}

std::string fixed(double value, int decimals) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof(text), value, std::chars_format::fixed, decimals).ptr;
  return std::string(text, end);
}

std::string size_text(ImageSize size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

std::string color_text(const std::array<std::uint8_t, 3>& color) {
  return "(" + std::to_string(color[0]) + ", " + std::to_string(color[1]) + ", " + std::to_string(color[2]) + ")";
}

struct HeatStop {
  int level;
  int color[3];
};

constexpr HeatStop kHeat[] = {{1, {40, 70, 200}}, {4, {140, 30, 160}}, {16, {230, 50, 40}}, {64, {255, 240, 170}}};

std::array<std::uint8_t, 3> heat_color(int level) {
  const HeatStop* upper = std::begin(kHeat);
  while (upper + 1 != std::end(kHeat) && upper->level < level) ++upper;
  std::array<std::uint8_t, 3> color{};
  const HeatStop* lower = upper == std::begin(kHeat) ? upper : upper - 1;
  const int span = std::max(1, upper->level - lower->level);
  const int part = std::clamp(level - lower->level, 0, span);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const int value = lower->color[channel] + (upper->color[channel] - lower->color[channel]) * part / span;
    color[channel] = static_cast<std::uint8_t>(value);
  }
  return color;
}

}  // namespace

bool row_differs(const Image& first, const Image& second, int row) {
  return std::memcmp(row_of(first, row), row_of(second, row), 3 * static_cast<std::size_t>(first.size.width)) != 0;
}

ImageDifference compare_images(const Image& first, const Image& second, int threshold) {
  ImageDifference result{.first_size = first.size, .second_size = second.size, .threshold = threshold, .worst = {}};
  if (first.size != second.size) {
    result.verdict = ImageVerdict::kSizeMismatch;
    return result;
  }
  if (first.pixels == second.pixels) return result;
  result.verdict = ImageVerdict::kDifferent;
  std::int64_t sum = 0;
  for (int y = 0; y < first.size.height; ++y) {
    if (!row_differs(first, second, y)) continue;
    const std::uint8_t* a = row_of(first, y);
    const std::uint8_t* b = row_of(second, y);
    for (int x = 0; x < first.size.width; ++x, a += 3, b += 3) {
      const int difference = pixel_difference(a, b);
      if (difference == 0) continue;
      sum += std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
      result.largest = std::max(result.largest, difference);
      if (difference > threshold) ++result.failing;
      keep_if_worst(
          result.worst,
          {.x = x, .y = y, .first = {a[0], a[1], a[2]}, .second = {b[0], b[1], b[2]}, .difference = difference});
    }
  }
  const double pixels = static_cast<double>(pixel_count(first));
  result.mean = static_cast<double>(sum) / (3 * pixels);
  result.failing_fraction = static_cast<double>(result.failing) / pixels;
  return result;
}

std::string describe(const ImageDifference& difference) {
  if (difference.verdict == ImageVerdict::kSizeMismatch) {
    return "sizes differ: " + size_text(difference.first_size) + " and " + size_text(difference.second_size) + "\n";
  }
  if (difference.verdict == ImageVerdict::kEqual) return "equal\n";
  std::string text = "largest difference " + std::to_string(difference.largest) + " levels, mean " +
                     fixed(difference.mean, 4) + ", " + std::to_string(difference.failing) + " pixels (" +
                     fixed(100 * difference.failing_fraction, 3) + " %) above " + std::to_string(difference.threshold) +
                     "\n";
  for (const PixelDifference& pixel : difference.worst) {
    text += "  (" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + "): " + color_text(pixel.first) +
            " and " + color_text(pixel.second) + ", difference " + std::to_string(pixel.difference) + "\n";
  }
  return text;
}

Image difference_picture(const Image& first, const Image& second) {
  assert(first.size == second.size);
  Image result = first;
  for (std::size_t i = 0; i < pixel_count(first); ++i) {
    std::uint8_t* out = result.pixels.data() + 3 * i;
    const int level = pixel_difference(out, second.pixels.data() + 3 * i);
    const std::array<std::uint8_t, 3> heat = heat_color(level);
    const int grey = (out[0] * 54 + out[1] * 183 + out[2] * 19) / (256 * 4);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      out[channel] = level == 0 ? static_cast<std::uint8_t>(grey) : heat[channel];
    }
  }
  return result;
}

std::string difference_text(const Image& first, const Image& second, int columns) {
  assert(first.size == second.size && columns > 0);
  constexpr std::string_view kScale = " .:-=+*#@";
  const int width = std::min(columns, first.size.width);
  // A character of a terminal is about twice as high as wide.
  const int height = std::max(1, static_cast<int>(static_cast<std::int64_t>(width) * first.size.height /
                                                  (2 * static_cast<std::int64_t>(first.size.width))));
  std::vector<int> largest(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  std::vector<std::size_t> column_of(static_cast<std::size_t>(first.size.width));
  for (std::size_t x = 0; x < column_of.size(); ++x)
    column_of[x] = x * static_cast<std::size_t>(width) / column_of.size();
  for (int y = 0; y < first.size.height; ++y) {
    if (!row_differs(first, second, y)) continue;
    const std::uint8_t* a = row_of(first, y);
    const std::uint8_t* b = row_of(second, y);
    int* cells = &largest[static_cast<std::size_t>(std::int64_t{y} * height / first.size.height * width)];
    for (const std::size_t column : column_of) {
      cells[column] = std::max(cells[column], pixel_difference(a, b));
      a += 3;
      b += 3;
    }
  }
  std::string text;
  for (std::size_t cell = 0; cell < largest.size(); ++cell) {
    text += kScale[std::bit_width(static_cast<unsigned>(largest[cell]))];
    if ((cell + 1) % static_cast<std::size_t>(width) == 0) text += '\n';
  }
  return text;
}

}  // namespace thinwall
