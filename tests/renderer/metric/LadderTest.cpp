#include "renderer/metric/Ladder.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/image/TestImages.hpp"
#include "tests/renderer/metric/MetricImages.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kLadderSize{160, 110};

PictureOptions limits(PictureLimits limits) {
  PictureOptions options;
  options.limits = limits;
  return options;
}

TEST(Ladder, EqualPicturesEndAtTheirBytes) {
  const PictureComparison result =
      climb_ladder(shaded_image(kLadderSize), shaded_image(kLadderSize), limits({.flip = 0.1}));
  EXPECT_TRUE(result.within);
  EXPECT_EQ(result.rung, "bytes");
  EXPECT_FALSE(result.flip);
}

TEST(Ladder, WithoutLimitsOneLevelInOnePixelIsADifference) {
  const Image first = shaded_image(kLadderSize);
  Image second = first;
  second.pixels[1000] ^= 1;
  EXPECT_FALSE(climb_ladder(first, second).within);
  EXPECT_TRUE(climb_ladder(first, second, limits({.largest = 1})).within);
}

TEST(Ladder, AnotherSizeIsToldAndNeverWithin) {
  const PictureComparison result =
      climb_ladder(plain_image({4, 3}, 0, 0, 0), plain_image({3, 4}, 0, 0, 0), limits({.largest = 255}));
  EXPECT_FALSE(result.within);
  EXPECT_EQ(result.rung, "size");
  EXPECT_EQ(result.verdict, "3 x 4 pixels instead of 4 x 3");
}

TEST(Ladder, CheapRungsSaveTheDearOnes) {
  const Image first = shaded_image(kLadderSize);
  const PictureComparison result =
      climb_ladder(first, upside_down(first), limits({.largest = 8, .structure = 0.9, .flip = 0.5}));
  EXPECT_FALSE(result.within);
  EXPECT_EQ(result.rung, "pixels");
  EXPECT_FALSE(result.structure);
  EXPECT_FALSE(result.flip);
}

TEST(Ladder, EachLimitIsHeld) {
  const Image first = shaded_image(kLadderSize);
  const Image second = shaded_image(kLadderSize, 1);
  EXPECT_FALSE(climb_ladder(first, second, limits({.mean = 0.01})).within);
  EXPECT_FALSE(climb_ladder(first, second, limits({.drift = 1e-5})).within);
  EXPECT_FALSE(climb_ladder(first, second, limits({.failing = 0.01})).within);
  EXPECT_FALSE(climb_ladder(first, second, limits({.structure = 0.9999})).within);
  EXPECT_FALSE(climb_ladder(first, second, limits({.flip = 0.01})).within);
  EXPECT_FALSE(climb_ladder(first, second, limits({.flip_99 = 0.01})).within);
  EXPECT_TRUE(climb_ladder(first, second, limits({.mean = 200, .structure = 0, .flip = 1, .flip_99 = 1})).within);
}

TEST(Ladder, TheVerdictNamesFiguresAndLimits) {
  const Image first = plain_image({10, 10}, 100, 100, 100);
  Image second = first;
  second.pixels[0] = 130;
  EXPECT_EQ(climb_ladder(first, second, limits({.largest = 8, .mean = 0.5})).verdict,
            "largest difference 30 (allowed 8), mean 0.1 (allowed 0.5)");
}

TEST(Ladder, AFigureIsToldInAsManyDigitsAsItTakesToStandOnItsSideOfTheLimit) {
  const Image first = plain_image({100, 100}, 100, 100, 100);
  Image second = first;
  second.pixels[0] = 101;  // of 30 000 numbers: a mean of 3.3333...e-05
  const auto told = [&](double mean) { return climb_ladder(first, second, limits({.mean = mean})).verdict; };
  EXPECT_EQ(told(0.1), "largest difference 1, mean 3.333e-05 (allowed 0.1)");
  EXPECT_EQ(told(3.3333e-05), "largest difference 1, mean 3.33333e-05 (allowed 3.3333e-05)");
  EXPECT_EQ(told(3.3334e-05), "largest difference 1, mean 3.333e-05 (allowed 3.3334e-05)");
  const PictureComparison structure = climb_ladder(first, second, limits({.structure = 0.9999999999}));
  EXPECT_FALSE(structure.within);
  EXPECT_NE(structure.verdict.find("(needed 0.9999999999)"), std::string::npos) << structure.verdict;
  EXPECT_NE(structure.verdict.find("SSIM 0.99999"), std::string::npos) << structure.verdict;
}

TEST(Ladder, WantedFiguresAreThereAlsoWhenNothingNeedsThem) {
  PictureOptions options;
  options.wanted = {.structure = true, .flip = true};
  const Image first = shaded_image(kLadderSize);
  const PictureComparison result = climb_ladder(first, shaded_image(kLadderSize, 1), options);
  EXPECT_FALSE(result.within);
  ASSERT_TRUE(result.structure && result.flip);
  EXPECT_GT(result.flip->mean, 0.01);
}

TEST(Ladder, MaskedPixelsCountNowhere) {
  const Image first = plain_image({10, 10}, 100, 100, 100);
  Image second = first;
  second.pixels[0] = 255;
  PictureOptions options;
  options.mask.assign(100, 1);
  options.mask[0] = 0;
  EXPECT_TRUE(climb_ladder(first, second, options).within);
  options.mask[0] = 1;
  EXPECT_FALSE(climb_ladder(first, second, options).within);
}

/// What a golden of usual limits has to catch, however dark it is: 8 levels, 0.2 on average, a drift of 0.001.
TEST(Ladder, ChangesThatMatterAreCaughtAndNoiseIsNot) {
  const Image image = shaded_image(kLadderSize);
  const auto passes = [&](const Image& other) {
    return climb_ladder(image, other, limits({.largest = 8, .mean = 0.2, .drift = 0.001})).within;
  };
  const Image dark = tinted(image, 0.3, 0.3, 0.3);
  const PictureComparison gain =
      climb_ladder(dark, tinted(dark, 1.01, 1.01, 1.01), limits({.largest = 8, .mean = 0.2, .drift = 0.001}));
  EXPECT_LT(gain.difference.mean, 0.2) << "the mean alone would let it pass";
  EXPECT_FALSE(gain.within) << gain.verdict;
  EXPECT_FALSE(passes(shaded_image(kLadderSize, 1))) << "shifted by a pixel";
  EXPECT_FALSE(passes(tinted(image, 1.01, 1.01, 1.01))) << "a gain of 1 %";
  EXPECT_FALSE(passes(tinted(image, 1.02, 1, 0.98))) << "another hue";
  EXPECT_FALSE(passes(upside_down(image)));
  EXPECT_TRUE(passes(rounded_otherwise(image))) << "one level in every seventh byte";
}

}  // namespace
}  // namespace thinwall
