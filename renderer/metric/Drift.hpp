#pragma once

#include <array>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// How much darker or lighter a picture is as a whole, in each of its colours: what rounding at edges leaves as it is,
/// because it goes both ways, while a gain, a light, a hue or a gamma changes it however dark the picture is.
struct Drift {
  std::array<double, 3> channels = {};  // red, green, blue: change of the mean level, relative to the first picture's
  double largest() const;               // of the channels, without its sign
};

/// The sizes must be equal. A mean below one level counts as one.
Drift drift(const Image& first, const Image& second);

}  // namespace thinwall
