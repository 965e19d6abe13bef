#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace thinwall {

/// A part of a whole as maps of bytes have it: 255 for all of it.
inline std::uint8_t byte_of(float part) {
  constexpr float kRounding = 0.5F;
  return static_cast<std::uint8_t>(255.0F * part + kRounding);
}

/// Blurs a square map of `kSide` by `kSide` values, along its columns and then along its rows; beyond the border lies
/// what lies at it. `weights`: by the distance from the middle, in steps of `apart` values. `memory`: of the map's
/// size.
template <std::size_t kSide, std::size_t kTaps>
void blur_map(std::vector<float>& map, const std::array<float, kTaps>& weights, std::size_t apart,
              std::vector<float>& memory) {
  for (std::size_t row = 0; row < kSide; ++row) {
    const float* middle = map.data() + kSide * row;
    float* to = memory.data() + kSide * row;
    for (std::size_t i = 0; i < kSide; ++i) to[i] = weights[0] * middle[i];
    for (std::size_t tap = 1; tap < kTaps; ++tap) {
      const std::size_t away = apart * tap;
      const float* below = map.data() + kSide * (row - std::min(away, row));
      const float* above = map.data() + kSide * std::min(row + away, kSide - 1);
      for (std::size_t i = 0; i < kSide; ++i) to[i] += weights[tap] * (below[i] + above[i]);
    }
  }
  std::array<float, 3 * kSide> wide;
  for (std::size_t row = 0; row < kSide; ++row) {
    const float* from = memory.data() + kSide * row;
    std::fill_n(wide.begin(), kSide, from[0]);
    std::copy_n(from, kSide, wide.begin() + kSide);
    std::fill_n(wide.begin() + 2 * kSide, kSide, from[kSide - 1]);
    float* to = map.data() + kSide * row;
    for (std::size_t i = 0; i < kSide; ++i) to[i] = weights[0] * from[i];
    for (std::size_t tap = 1; tap < kTaps; ++tap) {
      const float *before = wide.data() + kSide - apart * tap, *after = wide.data() + kSide + apart * tap;
      for (std::size_t i = 0; i < kSide; ++i) to[i] += weights[tap] * (before[i] + after[i]);
    }
  }
}

}  // namespace thinwall
