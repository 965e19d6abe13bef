#pragma once

#include <algorithm>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// Pixels of the unit that all over pictures is measured in: 1/720 of the picture's height. More in small pictures,
/// whose letters nobody could read.
inline double overlay_unit(ImageSize picture) {
  constexpr double kReadable = 0.5, kMostGrown = 1.5;  // pixels, and over what the height gives
  const double unit = picture.height / 720.0;
  return std::max(unit, std::min(kReadable, kMostGrown * unit));
}

}  // namespace thinwall
