#include "renderer/image/Resize.hpp"

#include <gtest/gtest.h>

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

TEST(Resize, FittingSizeKeepsTheShape) {
  EXPECT_EQ(size_that_fits({1280, 720}, {320, 320}), (ImageSize{320, 180}));
  EXPECT_EQ(size_that_fits({720, 1280}, {320, 320}), (ImageSize{180, 320}));
  EXPECT_EQ(size_that_fits({4000, 1}, {10, 10}), (ImageSize{10, 1}));
}

}  // namespace
}  // namespace thinwall
