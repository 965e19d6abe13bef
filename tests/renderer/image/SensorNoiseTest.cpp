#include "renderer/image/SensorNoise.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thinwall {
namespace {

Image flat(std::uint8_t level) {
  return {.size = {400, 300}, .pixels = std::vector<std::uint8_t>(3UL * 400 * 300, level)};
}

Image noisy(std::uint8_t level, double strength, std::uint64_t seed = 1, std::uint64_t moment = 7) {
  Image image = flat(level);
  add_sensor_noise(image, strength, seed, moment);
  return image;
}

TEST(SensorNoise, HasTheStatedMeanAndVariance) {
  for (const int level : {30, 128, 220}) {
    const Image image = noisy(static_cast<std::uint8_t>(level), 3);
    double sum = 0, squares = 0;
    for (const std::uint8_t value : image.pixels) {
      sum += value - level;
      squares += (value - level) * (value - level);
    }
    const double count = static_cast<double>(image.pixels.size());
    const double part = level / 255.0;
    const double variance = 9 * 4 * part * (1 - part) + 1.0 / 12;  // rounding adds a twelfth
    // Of 360 000 values the mean is known to deviation / 600, the variance to a part of sqrt(2) / 600; five times that.
    EXPECT_NEAR(sum / count, 0, 5 * std::sqrt(variance) / 600);
    EXPECT_NEAR(squares / count, variance, 5 * variance * std::sqrt(2) / 600);
  }
}

TEST(SensorNoise, IsTheSameForTheSameSeedAndMomentAndElseAnother) {
  EXPECT_EQ(noisy(128, 2).pixels, noisy(128, 2).pixels);
  EXPECT_NE(noisy(128, 2).pixels, noisy(128, 2, 2).pixels);
  EXPECT_NE(noisy(128, 2).pixels, noisy(128, 2, 1, 8).pixels);
}

TEST(SensorNoise, NeighboursAreIndependent) {
  const Image image = noisy(128, 3);
  double product = 0, squares = 0;
  for (std::size_t i = 3; i < image.pixels.size(); ++i) {
    product += (image.pixels[i] - 128) * (image.pixels[i - 3] - 128);
    squares += (image.pixels[i] - 128) * (image.pixels[i] - 128);
  }
  EXPECT_NEAR(product / squares, 0, 5.0 / 600);
}

TEST(SensorNoise, LeavesBlackAndWhiteAlone) {
  EXPECT_EQ(noisy(0, 5).pixels, flat(0).pixels);
  EXPECT_EQ(noisy(255, 5).pixels, flat(255).pixels);
}

}  // namespace
}  // namespace thinwall
