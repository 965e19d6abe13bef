#pragma once

#include <cstdint>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// A picture whose file holds more than 8-bit colours: finer ones, or transparency.
struct DeepImage {
  ImageSize size;
  std::vector<std::uint16_t> values;  // (height x width x 4), red green blue alpha, 0 to 65535
};

/// As 8-bit colours with transparency laid over white.
Image flattened(const DeepImage& image);

/// Opaque, each 8-bit level v as 257 v.
DeepImage deepened(const Image& image);

/// Whether it holds nothing that an 8-bit opaque picture cannot.
bool is_plain(const DeepImage& image);

struct DeepDifference {
  double largest = 0;  // 8-bit levels, over colours and alpha
  double mean = 0;     // 8-bit levels
};

/// `mask`, when not empty, is (height x width), zero where nothing counts. The sizes must be equal.
DeepDifference compare_deep(const DeepImage& first, const DeepImage& second,
                            const std::vector<std::uint8_t>& mask = {});

}  // namespace thinwall
