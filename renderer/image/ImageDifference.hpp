#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

enum class ImageVerdict {
  kEqual,         // every byte
  kDifferent,     // same size, some byte differs
  kSizeMismatch,  // nothing else can be said
};

struct PixelDifference {
  int x = 0;  // column, 0 on the left
  int y = 0;  // row, 0 on top
  std::array<std::uint8_t, 3> first{};
  std::array<std::uint8_t, 3> second{};
  int difference = 0;  // the largest of the three channels, 8-bit levels
};

/// What sets two pictures apart, in 8-bit levels. The difference of a pixel is the largest of its three channels.
struct ImageDifference {
  ImageVerdict verdict = ImageVerdict::kEqual;
  ImageSize first_size;
  ImageSize second_size;
  int largest = 0;                     // levels
  double mean = 0;                     // levels, over all pixels and channels
  int threshold = 0;                   // levels, as asked for
  std::int64_t failing = 0;            // pixels whose difference is above the threshold
  double failing_fraction = 0;         // 0 to 1
  std::vector<PixelDifference> worst;  // up to ten that differ, largest difference first, then from the top left
};

/// Whether any byte of the row differs. The sizes must be equal.
bool row_differs(const Image& first, const Image& second, int row);

ImageDifference compare_images(const Image& first, const Image& second, int threshold = 0);

/// One line, and one for each of the worst pixels: for a log.
std::string describe(const ImageDifference& difference);

/// Heat map of the pixels' differences on the darkened first picture: untouched where equal, blue for 1 level over
/// red to yellow-white for 64 levels and more. The sizes must be equal.
Image difference_picture(const Image& first, const Image& second);

/// The same as text, `columns` characters wide and in shape, for a log: each character is the largest difference in its
/// cell on the scale " .:-=+*#@" (0, 1, 2 to 3, 4 to 7, ... 128 to 255). The sizes must be equal.
std::string difference_text(const Image& first, const Image& second, int columns = 64);

}  // namespace thinwall
