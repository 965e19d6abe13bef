#include "renderer/image/Resize.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "tests/renderer/image/TestImages.hpp"

namespace thinwall {
namespace {

double mean_level(const Image& image) {
  return std::accumulate(image.pixels.begin(), image.pixels.end(), 0.0) / static_cast<double>(image.pixels.size());
}

TEST(Resize, SameSizeChangesNothing) {
  const Image image = patterned_image({13, 7});
  EXPECT_EQ(resize(image, {13, 7}).pixels, image.pixels);
}

TEST(Resize, HalfSizeIsTheMeanOfFourPixels) {
  const Image image{.size = {2, 2}, .pixels = {0, 10, 20, 4, 10, 21, 8, 10, 22, 100, 10, 23}};
  const Image half = resize(image, {1, 1});
  EXPECT_EQ(half.pixels, (std::vector<std::uint8_t>{28, 10, 22}));  // 21.5 rounds up
}

TEST(Resize, PartlyCoveredPixelsCountByTheirArea) {
  // Three columns into two: the middle one belongs to both by half.
  const Image image{.size = {3, 1}, .pixels = {0, 0, 0, 90, 90, 90, 210, 210, 210}};
  EXPECT_EQ(resize(image, {2, 1}).pixels, (std::vector<std::uint8_t>{30, 30, 30, 170, 170, 170}));
}

TEST(Resize, PlainStaysPlainAtAnySize) {
  const Image image = plain_image({37, 23}, 12, 200, 255);
  for (const ImageSize size : {ImageSize{5, 3}, ImageSize{36, 22}, ImageSize{80, 60}, ImageSize{1, 1}}) {
    EXPECT_EQ(resize(image, size).pixels, plain_image(size, 12, 200, 255).pixels);
  }
}

TEST(Resize, KeepsTheMeanLevel) {
  const Image image = patterned_image({97, 61});
  // Each level is rounded by at most half.
  EXPECT_NEAR(mean_level(resize(image, {20, 11})), mean_level(image), 0.5);
}

/// The level of a new pixel, from the overlap of its square with each old one.
int level_at(const Image& image, ImageSize size, int x, int y, int channel) {
  const std::int64_t width = image.size.width, height = image.size.height, area = width * height;
  const auto overlap = [](std::int64_t old, std::int64_t old_count, std::int64_t now, std::int64_t new_count) {
    return std::max<std::int64_t>(
        0, std::min((old + 1) * new_count, (now + 1) * old_count) - std::max(old * new_count, now * old_count));
  };
  std::int64_t sum = 0;
  for (int row = 0; row < height; ++row) {
    const std::int64_t rows = overlap(row, height, y, size.height);
    if (rows == 0) continue;
    for (int column = 0; column < width; ++column) {
      const auto pixel = static_cast<std::size_t>(3 * (row * width + column) + channel);
      sum += rows * overlap(column, width, x, size.width) * image.pixels[pixel];
    }
  }
  return static_cast<int>((sum + area / 2) / area);
}

TEST(Resize, IsTheRoundedMeanOfWhatAPixelCovers) {
  const Image image = patterned_image({97, 61});
  for (const ImageSize size : {ImageSize{20, 11}, ImageSize{96, 7}, ImageSize{130, 70}}) {
    const Image other = resize(image, size);
    for (int i = 0; i < 3 * size.width * size.height; ++i) {
      ASSERT_EQ(other.pixels[static_cast<std::size_t>(i)],
                level_at(image, size, i / 3 % size.width, i / 3 / size.width, i % 3));
    }
  }
}

TEST(Resize, HoldsTheSumsOfLargePictures) {
  // 256 times this area is more than 32 bits hold.
  const Image image = plain_image({4100, 4100}, 255, 254, 1);
  EXPECT_EQ(resize(image, {3, 2}).pixels, plain_image({3, 2}, 255, 254, 1).pixels);
}

TEST(Resize, FittingSizeKeepsTheShape) {
  EXPECT_EQ(size_that_fits({1280, 720}, {320, 320}), (ImageSize{320, 180}));
  EXPECT_EQ(size_that_fits({720, 1280}, {320, 320}), (ImageSize{180, 320}));
  EXPECT_EQ(size_that_fits({4000, 1}, {10, 10}), (ImageSize{10, 1}));
}

}  // namespace
}  // namespace thinwall
