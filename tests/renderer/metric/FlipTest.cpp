#include "renderer/metric/Flip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "renderer/metric/ColorSpace.hpp"
#include "tests/renderer/image/TestImages.hpp"
#include "tests/renderer/metric/MetricImages.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kFlipSize{160, 110};

/// The error between two plain colours, in which nothing is left of the filters: the paper's section 4.1.3 alone.
double plain_error(const std::array<double, 3>& first, const std::array<double, 3>& second) {
  const auto distance = [](std::array<double, 3> a, std::array<double, 3> b) {
    for (auto* lab : {&a, &b}) {
      (*lab)[1] *= 0.01 * (*lab)[0];
      (*lab)[2] *= 0.01 * (*lab)[0];
    }
    return std::pow(std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]), 0.7);
  };
  const double largest = distance(lab_of_linear({0, 1, 0}), lab_of_linear({0, 0, 1}));
  const double error = distance(lab_of_linear(first), lab_of_linear(second));
  const double knee = 0.4 * largest;
  return error < knee ? 0.95 * error / knee : 0.95 + 0.05 * (error - knee) / (largest - knee);
}

std::array<double, 3> linear(int red, int green, int blue) {
  const auto& levels = linear_levels();
  return {levels[static_cast<std::size_t>(red)], levels[static_cast<std::size_t>(green)],
          levels[static_cast<std::size_t>(blue)]};
}

TEST(Flip, EqualPicturesHaveNoError) {
  const FlipResult result = flip(shaded_image(kFlipSize), shaded_image(kFlipSize));
  EXPECT_EQ(result.mean, 0);
  EXPECT_EQ(result.largest, 0);
  EXPECT_EQ(result.percentile_99, 0);
}

TEST(Flip, PlainColorsHaveTheErrorOfTheFormula) {
  const int colors[][6] = {{0, 0, 0, 255, 255, 255},
                           {0, 255, 0, 0, 0, 255},
                           {120, 60, 50, 124, 60, 50},
                           {30, 30, 30, 31, 31, 31},
                           {200, 90, 80, 150, 90, 80}};
  for (const auto& c : colors) {
    const auto level = [&](int i) { return static_cast<std::uint8_t>(c[i]); };
    const FlipResult result =
        flip(plain_image({30, 20}, level(0), level(1), level(2)), plain_image({30, 20}, level(3), level(4), level(5)));
    // The filters' weights sum to one but for rounding; the power 0.7 steepens that for small errors.
    EXPECT_NEAR(result.mean, plain_error(linear(c[0], c[1], c[2]), linear(c[3], c[4], c[5])), 3e-5) << c[0] << c[3];
    EXPECT_NEAR(result.largest - result.mean, 0, 3e-5);
  }
}

/// Means that the published program (version 1.6) prints for these pictures.
TEST(Flip, EqualsThePublishedProgram) {
  const Image reference = shaded_image(kFlipSize);
  EXPECT_NEAR(flip(reference, shaded_image(kFlipSize, 1)).mean, 0.078579, 1e-5);
  EXPECT_NEAR(flip(reference, tinted(reference, 1.01, 1.01, 1.01)).mean, 0.042996, 1e-5);
  EXPECT_NEAR(flip(reference, tinted(reference, 1.05, 1, 0.95)).mean, 0.103822, 1e-5);
  EXPECT_NEAR(flip(reference, upside_down(reference)).mean, 0.115374, 1e-5);
  EXPECT_NEAR(flip(reference, patterned_image(kFlipSize)).mean, 0.838777, 1e-5);
  EXPECT_NEAR(flip(reference, upside_down(reference)).largest, 0.865773, 2e-5);
}

TEST(Flip, IsTheSameBothWays) {
  const Image first = shaded_image(kFlipSize);
  const Image second = shaded_image(kFlipSize, 2);
  EXPECT_NEAR(flip(first, second).mean, flip(second, first).mean, 1e-12);
}

TEST(Flip, ThreadsChangeNoBit) {
  const Image first = shaded_image({300, 280});
  const Image second = tinted(shaded_image({300, 280}, 1), 1.02, 1, 1);
  const FlipResult one = flip(first, second, {.threads = 1});
  for (const int threads : {2, 3, 8}) {
    const FlipResult more = flip(first, second, {.threads = threads});
    EXPECT_EQ(one.mean, more.mean);
    EXPECT_EQ(one.map, more.map);
  }
}

TEST(Flip, EqualSquaresThatAreLeftOutWouldHaveHadNoError) {
  const ImageSize size{400, 300};
  const Image first = shaded_image(size);
  Image second = first;
  // On the border of two squares, so that the error reaches into the other.
  const auto pixel = [&](int x, int y) { return static_cast<std::size_t>(3 * (y * size.width + x)); };
  for (int y = 60; y < 64; ++y) {
    for (int x = 124; x < 128; ++x) second.pixels[pixel(x, y)] = 255;
  }
  Image everywhere = second;
  // One level in the far corners makes every square differ.
  for (const auto& [x, y] : {std::pair{399, 299}, {0, 299}, {399, 0}, {270, 270}, {150, 290}}) {
    everywhere.pixels[pixel(x, y)] ^= 1;
  }
  const FlipResult local = flip(first, second);
  const FlipResult whole = flip(first, everywhere);
  for (int y = 0; y < 130; ++y) {
    for (int x = 0; x < 250; ++x) {
      const auto at = static_cast<std::size_t>(y * size.width + x);
      ASSERT_EQ(local.map[at], whole.map[at]) << x << " " << y;
    }
  }
  EXPECT_GT(local.map[static_cast<std::size_t>(62 * size.width + 130)], 0.0F);
}

TEST(Flip, OnePixelIsAPicture) {
  EXPECT_NEAR(flip(plain_image({1, 1}, 0, 0, 0), plain_image({1, 1}, 255, 255, 255)).mean,
              plain_error({0, 0, 0}, {1, 1, 1}), 3e-5);
}

TEST(Flip, AViewerFartherAwaySeesLessOfAFinePattern) {
  Image first = plain_image({64, 64}, 100, 100, 100);
  Image second = first;
  for (std::size_t i = 0; i < 64 * 64; ++i) {
    const bool light = (i % 64 + i / 64) % 2 == 0;
    for (std::size_t c = 0; c < 3; ++c) {
      first.pixels[3 * i + c] = light ? 110 : 90;
      second.pixels[3 * i + c] = light ? 90 : 110;
    }
  }
  EXPECT_LT(flip(first, second, {.pixels_per_degree = 90}).mean, flip(first, second, {.pixels_per_degree = 30}).mean);
}

FloatImage bright_image(double gain, int shift) {
  FloatImage image{.size = kFlipSize, .channels = 3, .values = {}};
  for (int y = 0; y < kFlipSize.height; ++y) {
    for (int column = 0; column < kFlipSize.width; ++column) {
      const int x = column - shift;
      const double squares = (x / 16 + y / 16) % 2 * 0.3;
      const double light = 0.02 + squares + 50 * gain * std::exp(-((x - 80) * (x - 80) + (y - 50) * (y - 50)) / 200.0);
      image.values.push_back(static_cast<float>(light));
      image.values.push_back(static_cast<float>(light * 0.7 + 0.001 * x));
      image.values.push_back(static_cast<float>(light * 0.4 + 0.002 * y));
    }
  }
  return image;
}

TEST(HighRangeFlip, EqualsThePublishedProgram) {
  const FloatImage reference = bright_image(1, 0);
  EXPECT_NEAR(flip_high_range(reference, bright_image(1, 2)).mean, 0.247860, 1e-5);
  EXPECT_NEAR(flip_high_range(reference, bright_image(1.3, 0)).mean, 0.073019, 1e-5);
  const ExposureRange range = exposure_range(reference);
  EXPECT_NEAR(range.first, -4.1348, 1e-4);
  EXPECT_NEAR(range.last, 2.9826, 1e-4);
  EXPECT_EQ(range.count, 8);
}

TEST(HighRangeFlip, ANumberThatIsNoneIsTheLargestErrorAndSpoilsNoOther) {
  const FloatImage reference = bright_image(1, 0);
  FloatImage test = reference;
  test.values[3 * 50] = std::numeric_limits<float>::quiet_NaN();
  const FlipResult result = flip_high_range(reference, test);
  EXPECT_EQ(result.map[50], 1.0F);
  EXPECT_EQ(result.map[50 + 80 * 160], 0.0F);
  EXPECT_TRUE(std::isfinite(result.mean));
}

TEST(HighRangeFlip, ABlackReferenceHasAnExposureAllTheSame) {
  const FloatImage black{.size = {8, 8}, .channels = 3, .values = std::vector<float>(192, 0.0F)};
  const FloatImage grey{.size = {8, 8}, .channels = 3, .values = std::vector<float>(192, 0.5F)};
  EXPECT_EQ(flip_high_range(black, black).mean, 0);
  EXPECT_GT(flip_high_range(black, grey).mean, 0.5);
}

}  // namespace
}  // namespace thinwall
