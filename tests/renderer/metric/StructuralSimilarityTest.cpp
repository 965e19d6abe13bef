#include "renderer/metric/StructuralSimilarity.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "renderer/metric/ColorSpace.hpp"
#include "tests/renderer/image/TestImages.hpp"
#include "tests/renderer/metric/MetricImages.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSimilaritySize{300, 200};

TEST(StructuralSimilarity, EqualPicturesHaveOne) {
  const StructuralSimilarity result =
      structural_similarity(shaded_image(kSimilaritySize), shaded_image(kSimilaritySize));
  EXPECT_EQ(result.mean, 1);
  EXPECT_EQ(result.lowest, 1);
}

TEST(StructuralSimilarity, PlainGreysHaveTheLuminanceTermAlone) {
  const auto lightness = [](int level) {
    const double light = linear_levels()[static_cast<std::size_t>(level)];
    return lab_of_linear({light, light, light})[0];
  };
  const double a = lightness(60);
  const double b = lightness(180);
  const double term = (2 * a * b + 1) / (a * a + b * b + 1);
  const StructuralSimilarity result =
      structural_similarity(plain_image({40, 30}, 60, 60, 60), plain_image({40, 30}, 180, 180, 180));
  // Variances of rounding stand against the constant 9 in the second factor.
  EXPECT_NEAR(result.mean, 0.5 * term + 0.5, 1e-4);
  EXPECT_NEAR(result.lowest, result.mean, 1e-4);
}

TEST(StructuralSimilarity, IsTheSameBothWaysAndForAnyThreads) {
  const Image first = shaded_image(kSimilaritySize);
  const Image second = shaded_image(kSimilaritySize, 1);
  const StructuralSimilarity result = structural_similarity(first, second, 1);
  EXPECT_EQ(result.mean, structural_similarity(first, second, 3).mean);
  EXPECT_NEAR(result.mean, structural_similarity(second, first, 2).mean, 1e-7);
}

TEST(StructuralSimilarity, FallsWithTheShift) {
  const Image first = shaded_image(kSimilaritySize);
  const double one = structural_similarity(first, shaded_image(kSimilaritySize, 1)).mean;
  const double four = structural_similarity(first, shaded_image(kSimilaritySize, 4)).mean;
  EXPECT_LT(one, 0.99);
  EXPECT_LT(four, one);
}

TEST(StructuralSimilarity, SeesAChangeOfColorAtTheSameLightness) {
  const Image first = shaded_image(kSimilaritySize);
  Image swapped = first;
  for (std::size_t i = 0; i < swapped.pixels.size(); i += 3) std::swap(swapped.pixels[i], swapped.pixels[i + 2]);
  EXPECT_LT(structural_similarity(first, swapped).mean, 0.9);
}

TEST(StructuralSimilarity, ReversedStructureIsNegative) {
  Image first = plain_image({32, 32}, 100, 100, 100);
  Image second = first;
  for (std::size_t i = 0; i < 32 * 32; ++i) {
    const bool light = (i % 32 / 2 + i / 32 / 2) % 2 == 0;
    for (std::size_t c = 0; c < 3; ++c) {
      first.pixels[3 * i + c] = light ? 200 : 20;
      second.pixels[3 * i + c] = light ? 20 : 200;
    }
  }
  EXPECT_LT(structural_similarity(first, second).lowest, 0.1);
}

}  // namespace
}  // namespace thinwall
