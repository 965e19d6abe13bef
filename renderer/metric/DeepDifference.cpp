#include "renderer/metric/DeepDifference.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace thinwall {
namespace {

constexpr unsigned kFull = 65535;
constexpr unsigned kStep = 257;  // of 16 bits for each level of 8

}  // namespace

Image flattened(const DeepImage& image) {
  Image result{.size = image.size, .pixels = {}};
  result.pixels.reserve(image.values.size() / 4 * 3);
  for (std::size_t i = 0; i < image.values.size(); i += 4) {
    const unsigned alpha = image.values[i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      const unsigned color = image.values[i + c];
      const auto over_white = static_cast<unsigned>((static_cast<std::uint64_t>(color) * alpha +
                                                     static_cast<std::uint64_t>(kFull) * (kFull - alpha) + kFull / 2) /
                                                    kFull);
      result.pixels.push_back(static_cast<std::uint8_t>((over_white + kStep / 2) / kStep));
    }
  }
  return result;
}

DeepImage deepened(const Image& image) {
  DeepImage result{.size = image.size, .values = {}};
  result.values.reserve(image.pixels.size() / 3 * 4);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      result.values.push_back(static_cast<std::uint16_t>(image.pixels[i + c] * kStep));
    }
    result.values.push_back(kFull);
  }
  return result;
}

bool is_plain(const DeepImage& image) {
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    if (i % 4 == 3 ? image.values[i] != kFull : image.values[i] % kStep != 0) return false;
  }
  return true;
}

DeepDifference compare_deep(const DeepImage& first, const DeepImage& second, const std::vector<std::uint8_t>& mask) {
  assert(first.size == second.size);
  int largest = 0;
  std::int64_t sum = 0, counted = 0;
  for (std::size_t i = 0; i < first.values.size(); ++i) {
    if (!mask.empty() && mask[i / 4] == 0) continue;
    ++counted;
    const int difference = std::abs(static_cast<int>(first.values[i]) - second.values[i]);
    largest = std::max(largest, difference);
    sum += difference;
  }
  const double count = static_cast<double>(std::max<std::int64_t>(1, counted));
  return {.largest = static_cast<double>(largest) / kStep, .mean = static_cast<double>(sum) / count / kStep};
}

}  // namespace thinwall
