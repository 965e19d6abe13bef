#include "renderer/image/SensorNoise.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace thinwall {
namespace {

/// The finalizer of SplitMix64 (Steele, Lea and Flood 2014): 64 well-mixed bits of a counter.
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15ULL;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

/// Sum of the four 16-bit parts, with mean zero and in units of its own standard deviation.
float bell(std::uint64_t bits) {
  constexpr float kMean = 4 * 0.5F * 65535;
  constexpr float kDeviation = 37837.2F;  // sqrt(4 (65536^2 - 1) / 12)
  const std::uint64_t sum = (bits & 0xffff) + ((bits >> 16) & 0xffff) + ((bits >> 32) & 0xffff) + (bits >> 48);
  return (static_cast<float>(sum) - kMean) / kDeviation;
}

}  // namespace

void add_sensor_noise(Image& image, double strength, std::uint64_t seed, std::uint64_t moment) {
  std::array<float, 256> deviation;
  for (std::size_t level = 0; level < deviation.size(); ++level) {
    const double part = static_cast<double>(level) / 255;
    deviation[level] = static_cast<float>(strength * std::sqrt(4 * part * (1 - part)));
  }
  const std::uint64_t stream = mixed(mixed(seed) ^ moment);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const std::uint8_t level = image.pixels[i];
    const float value = static_cast<float>(level) + deviation[level] * bell(mixed(stream + i));
    image.pixels[i] = static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
  }
}

}  // namespace thinwall
