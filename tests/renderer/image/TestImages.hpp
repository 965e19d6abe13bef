#pragma once

#include <cstddef>
#include <cstdint>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// Every pixel differs from its neighbours, and all levels occur in larger pictures.
inline Image patterned_image(ImageSize size) {
  Image image{.size = size, .pixels = {}};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      image.pixels.push_back(static_cast<std::uint8_t>(x * 7 + y * 3));
      image.pixels.push_back(static_cast<std::uint8_t>(x * 5 + y * 11 + 80));
      image.pixels.push_back(static_cast<std::uint8_t>(x * y + 200));
    }
  }
  return image;
}

inline Image plain_image(ImageSize size, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  Image image{.size = size, .pixels = {}};
  const std::size_t count = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  for (std::size_t i = 0; i < count; ++i) image.pixels.insert(image.pixels.end(), {red, green, blue});
  return image;
}

}  // namespace thinwall
