#include "renderer/metric/ErrorPicture.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace thinwall {
namespace {

constexpr float kUnseen = 0.005F;
constexpr float kStops[][3] = {{20, 30, 120}, {90, 20, 160}, {190, 30, 110}, {240, 120, 40}, {255, 245, 190}};
constexpr int kIntervals = 4;

}  // namespace

Image error_picture(const Image& image, const std::vector<float>& errors) {
  assert(errors.size() * 3 == image.pixels.size());
  Image result = image;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    std::uint8_t* out = &result.pixels[3 * i];
    if (errors[i] < kUnseen) {
      const int grey = (out[0] * 54 + out[1] * 183 + out[2] * 19) / (256 * 4);
      std::fill_n(out, 3, static_cast<std::uint8_t>(grey));
      continue;
    }
    const float place = std::clamp(errors[i], 0.0F, 1.0F) * kIntervals;
    const int lower = std::min(static_cast<int>(place), kIntervals - 1);
    const float part = place - static_cast<float>(lower);
    for (int c = 0; c < 3; ++c) {
      out[c] =
          static_cast<std::uint8_t>(std::lround(kStops[lower][c] + part * (kStops[lower + 1][c] - kStops[lower][c])));
    }
  }
  return result;
}

}  // namespace thinwall
