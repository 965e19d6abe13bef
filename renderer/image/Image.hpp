#pragma once

#include <cstdint>
#include <vector>

namespace thinwall {

struct ImageSize {
  int width = 1280;  // pixels
  int height = 720;  // pixels
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

/// An 8-bit sRGB picture, opaque, first row on top.
struct Image {
  ImageSize size;
  std::vector<std::uint8_t> pixels;  // (height x width x 3), red green blue, 0 to 255
};

}  // namespace thinwall
