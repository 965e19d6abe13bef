#include "renderer/metric/Drift.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace thinwall {
namespace {

std::array<std::int64_t, 3> sums(const Image& image) {
  std::array<std::int64_t, 3> sum{};
  for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
    for (std::size_t channel = 0; channel < 3; ++channel) sum[channel] += image.pixels[i + channel];
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
