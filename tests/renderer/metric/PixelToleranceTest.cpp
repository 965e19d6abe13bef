#include "renderer/metric/PixelTolerance.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/image/TestImages.hpp"
#include "tests/renderer/metric/MetricImages.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize{160, 110};

/// White columns on black.
Image with_lines(std::initializer_list<int> columns) {
  Image image = plain_image({20, 10}, 0, 0, 0);
  for (const int column : columns) {
    for (int y = 0; y < 10; ++y) {
      for (int c = 0; c < 3; ++c) image.pixels[static_cast<std::size_t>(3 * (20 * y + column) + c)] = 255;
    }
  }
  return image;
}

TEST(PixelTolerance, ALevelWithinTheToleranceDoesNotFail) {
  const Image first = plain_image({10, 10}, 100, 100, 100);
  EXPECT_EQ(failing_pixels(first, plain_image({10, 10}, 100, 104, 100), {.level = 4}).failing, 0);
  const FailingPixels all = failing_pixels(first, plain_image({10, 10}, 100, 105, 100), {.level = 4});
  EXPECT_EQ(all.failing, 100);
  EXPECT_EQ(all.fraction(), 1);
}

TEST(PixelTolerance, ALineMovedByAPixelIsExcusedByTheShiftOnly) {
  EXPECT_EQ(failing_pixels(with_lines({5}), with_lines({6}), {.shift = 0}).failing, 20);
  EXPECT_EQ(failing_pixels(with_lines({5}), with_lines({6}), {.shift = 1}).failing, 0);
  EXPECT_EQ(failing_pixels(with_lines({5}), with_lines({7}), {.shift = 1}).failing, 20);
}

TEST(PixelTolerance, AThinLineThatAppearsOrVanishesFailsBothWays) {
  EXPECT_EQ(failing_pixels(with_lines({}), with_lines({6}), {.shift = 1}).failing, 10);
  EXPECT_EQ(failing_pixels(with_lines({6}), with_lines({}), {.shift = 1}).failing, 10);
}

TEST(PixelTolerance, AShiftDoesNotExcuseAGainAHueOrALostHighlight) {
  const Image image = shaded_image(kSize);
  const PixelTolerance tolerance{.level = 2, .shift = 1};
  EXPECT_GT(failing_pixels(image, tinted(image, 1.06, 1.06, 1.06), tolerance).fraction(), 0.5);
  EXPECT_GT(failing_pixels(image, tinted(image, 1.06, 1, 0.94), tolerance).fraction(), 0.5);
  EXPECT_GT(failing_pixels(image, upside_down(image), tolerance).fraction(), 0.1);
}

TEST(PixelTolerance, WhatTheMaskCoversDoesNotCount) {
  const Image first = plain_image({4, 2}, 0, 0, 0);
  const Image second = plain_image({4, 2}, 9, 9, 9);
  std::vector<std::uint8_t> mask(8, 1);
  mask[0] = mask[5] = 0;
  const FailingPixels result = failing_pixels(first, second, {}, mask);
  EXPECT_EQ(result.counted, 6);
  EXPECT_EQ(result.failing, 6);
  EXPECT_EQ(result.where[5], 0);
  const Image masked = with_masked_pixels_of(second, first, mask);
  EXPECT_EQ(masked.pixels[0], 0);
  EXPECT_EQ(masked.pixels[3], 9);
}

TEST(PixelTolerance, AMaskPictureCountsWhereItIsLight) {
  Image picture = plain_image({3, 1}, 0, 0, 0);
  picture.pixels[4] = 128;
  picture.pixels[7] = 127;
  EXPECT_EQ(mask_of(picture), (std::vector<std::uint8_t>{0, 1, 0}));
}

}  // namespace
}  // namespace thinwall
