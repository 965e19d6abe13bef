#include "renderer/metric/Drift.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace thinwall {
namespace {

std::array<std::int64_t, 3> sums(const Image& image) {
  std::array<std::int64_t, 3> sum{};
  const std::size_t row = 3 * static_cast<std::size_t>(image.size.width);
  for (std::size_t begin = 0; begin < image.pixels.size(); begin += row) {
    // Whole pixels side by side fill the processor's vectors; a row's sum fits into 32 bits.
    std::array<std::uint32_t, 48> part{};
    const std::uint8_t* bytes = &image.pixels[begin];
    std::size_t i = 0;
    for (; i + part.size() <= row; i += part.size()) {
      for (std::size_t k = 0; k < part.size(); ++k) part[k] += bytes[i + k];
    }
    for (std::size_t k = 0; i + k < row; ++k) part[k] += bytes[i + k];
    for (std::size_t k = 0; k < part.size(); ++k) sum[k % 3] += part[k];
  }
  return sum;
}

}  // namespace

double Drift::largest() const {
  return std::max({std::abs(channels[0]), std::abs(channels[1]), std::abs(channels[2])});
}

Drift drift(const Image& first, const Image& second) {
  assert(first.size == second.size);
  const std::array<std::int64_t, 3> before = sums(first);
  const std::array<std::int64_t, 3> after = sums(second);
  const auto pixels = static_cast<std::int64_t>(first.pixels.size() / 3);
  Drift result;
  for (std::size_t channel = 0; channel < 3 && pixels > 0; ++channel) {
    result.channels[channel] =
        static_cast<double>(after[channel] - before[channel]) / static_cast<double>(std::max(before[channel], pixels));
  }
  return result;
}

}  // namespace thinwall
