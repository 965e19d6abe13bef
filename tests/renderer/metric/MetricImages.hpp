#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// A picture with soft shades, coloured edges, a thin line and a highlight, as rendered pictures have them.
inline Image shaded_image(ImageSize size, int shift = 0) {
  Image image{.size = size, .pixels = {}};
  const auto level = [](double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))); };
  for (int y = 0; y < size.height; ++y) {
    for (int column = 0; column < size.width; ++column) {
      const int x = column - shift;
      const bool inside = (x - 60) * (x - 60) + (y - 50) * (y - 50) < 40 * 40;
      const double shade = inside ? 200 - 0.03 * ((x - 60) * (x - 60) + (y - 50) * (y - 50)) : 70 + x / 8 % 2 * 20;
      const double light = 120 * std::exp(-((x - 45) * (x - 45) + (y - 35) * (y - 35)) / 30.0);
      const bool line = x == 120;
      image.pixels.push_back(level(shade + light));
      image.pixels.push_back(level((inside ? 0.45 : 0.9) * shade + light + (line ? 90 : 0)));
      image.pixels.push_back(level((inside ? 0.4 : 1.2) * shade + light));
    }
  }
  return image;
}

/// Each channel times its factor.
inline Image tinted(Image image, double red, double green, double blue) {
  const double factors[3] = {red, green, blue};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = static_cast<std::uint8_t>(std::lround(std::min(255.0, factors[i % 3] * image.pixels[i])));
  }
  return image;
}

/// One level more or less in every seventh byte, as often the one as the other.
inline Image rounded_otherwise(Image image) {
  for (std::size_t i = 0; i < image.pixels.size(); i += 14) {
    if (image.pixels[i] < 255) ++image.pixels[i];
    if (i + 7 < image.pixels.size() && image.pixels[i + 7] > 0) --image.pixels[i + 7];
  }
  return image;
}

inline Image upside_down(const Image& image) {
  Image result = image;
  const std::size_t row = static_cast<std::size_t>(image.size.width) * 3;
  for (int y = 0; y < image.size.height; ++y) {
    std::copy_n(&image.pixels[static_cast<std::size_t>(y) * row], row,
                &result.pixels[static_cast<std::size_t>(image.size.height - 1 - y) * row]);
  }
  return result;
}

}  // namespace thinwall
