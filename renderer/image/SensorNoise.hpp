#pragma once

#include <cstdint>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// Adds the noise of a camera's sensor: to each channel of each pixel a value of its own from a bell-shaped
/// distribution (sum of four uniform ones) with mean zero. Its standard deviation is `strength` (8-bit levels) at
/// mid-grey and falls to zero towards black and white as strength sqrt(4 x (1 - x)), with x the level from 0 to 1, so
/// that nothing is clipped. The result, rounded to levels, is a pure function of the picture, `seed` and `moment`.
void add_sensor_noise(Image& image, double strength, std::uint64_t seed, std::uint64_t moment);

}  // namespace thinwall
