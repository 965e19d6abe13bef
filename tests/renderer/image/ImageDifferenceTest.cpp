#include "renderer/image/ImageDifference.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/renderer/image/TestImages.hpp"

namespace thinwall {
namespace {

std::uint8_t& level(Image& image, int x, int y, int channel) {
  return image.pixels[static_cast<std::size_t>(3 * (y * image.size.width + x) + channel)];
}

TEST(ImageDifference, EqualPicturesAreEqual) {
  const ImageDifference result = compare_images(patterned_image({9, 5}), patterned_image({9, 5}));
  EXPECT_EQ(result.verdict, ImageVerdict::kEqual);
  EXPECT_EQ(result.largest, 0);
  EXPECT_EQ(result.mean, 0);
  EXPECT_TRUE(result.worst.empty());
  EXPECT_EQ(describe(result), "equal\n");
}

TEST(ImageDifference, AnotherSizeIsAVerdictOfItsOwn) {
  const ImageDifference result = compare_images(plain_image({20, 10}, 0, 0, 0), plain_image({10, 20}, 0, 0, 0));
  EXPECT_EQ(result.verdict, ImageVerdict::kSizeMismatch);
  EXPECT_EQ(describe(result), "sizes differ: 20 x 10 and 10 x 20\n");
}

TEST(ImageDifference, CountsLargestMeanAndFailingPixels) {
  const Image first = plain_image({10, 10}, 100, 100, 100);
  Image second = first;
  level(second, 3, 4, 0) = 130;  // +30
  level(second, 3, 4, 2) = 95;   // -5 in the same pixel
  level(second, 7, 9, 1) = 92;   // -8
  level(second, 0, 0, 1) = 101;  // +1
  const ImageDifference result = compare_images(first, second, 8);
  EXPECT_EQ(result.verdict, ImageVerdict::kDifferent);
  EXPECT_EQ(result.largest, 30);
  EXPECT_DOUBLE_EQ(result.mean, 44.0 / 300.0);
  EXPECT_EQ(result.failing, 1);  // 8 is not above 8
  EXPECT_DOUBLE_EQ(result.failing_fraction, 0.01);
  EXPECT_EQ(compare_images(first, second, 0).failing, 3);
}

TEST(ImageDifference, IsSymmetric) {
  const Image first = patterned_image({16, 16});
  const Image second = plain_image({16, 16}, 90, 90, 90);
  const ImageDifference there = compare_images(first, second, 10);
  const ImageDifference back = compare_images(second, first, 10);
  EXPECT_EQ(there.largest, back.largest);
  EXPECT_EQ(there.mean, back.mean);
  EXPECT_EQ(there.failing, back.failing);
}

TEST(ImageDifference, NamesTheTenWorstPixelsLargestFirst) {
  const Image first = plain_image({20, 2}, 50, 50, 50);
  Image second = first;
  for (int x = 0; x < 12; ++x) level(second, x, 1, 1) = static_cast<std::uint8_t>(51 + x);
  level(second, 2, 0, 0) = 62;  // as bad as the pixel (11, 1), and above it
  const ImageDifference result = compare_images(first, second);
  ASSERT_EQ(result.worst.size(), 10u);
  EXPECT_EQ(result.worst[0].x, 2);
  EXPECT_EQ(result.worst[0].y, 0);
  EXPECT_EQ(result.worst[1].x, 11);
  EXPECT_EQ(result.worst[1].y, 1);
  EXPECT_EQ(result.worst[9].difference, 4);
  EXPECT_EQ(result.worst[1].first, (std::array<std::uint8_t, 3>{50, 50, 50}));
  EXPECT_EQ(result.worst[1].second, (std::array<std::uint8_t, 3>{50, 62, 50}));
}

TEST(ImageDifference, DescriptionHasTheFiguresAndThePlaces) {
  const Image first = plain_image({10, 10}, 100, 100, 100);
  Image second = first;
  level(second, 3, 4, 0) = 130;
  EXPECT_EQ(describe(compare_images(first, second, 8)),
            "largest difference 30 levels, mean 0.1000, 1 pixels (1.000 %) above 8\n"
            "  (3, 4): (100, 100, 100) and (130, 100, 100), difference 30\n");
}

TEST(ImageDifference, PictureIsGreyWhereEqualAndHotWhereNot) {
  const Image first = plain_image({4, 1}, 200, 100, 100);
  Image second = first;
  level(second, 1, 0, 1) = 101;
  level(second, 2, 0, 1) = 255;
  const Image picture = difference_picture(first, second);
  EXPECT_EQ(picture.pixels[0], picture.pixels[1]);
  EXPECT_LT(picture.pixels[0], 64);
  EXPECT_EQ((std::vector<std::uint8_t>(picture.pixels.begin() + 3, picture.pixels.begin() + 9)),
            (std::vector<std::uint8_t>{40, 70, 200, 255, 240, 170}));
}

TEST(ImageDifference, TextShowsWhereAndHowMuch) {
  const Image first = plain_image({8, 8}, 0, 0, 0);
  Image second = first;
  level(second, 0, 0, 0) = 1;
  level(second, 3, 2, 2) = 40;
  level(second, 7, 7, 1) = 255;
  EXPECT_EQ(difference_text(first, second, 8),
            ".       \n"
            "   *    \n"
            "        \n"
            "       @\n");
}

TEST(ImageDifference, TextNeverLosesASinglePixelInALargePicture) {
  const Image first = plain_image({640, 360}, 9, 9, 9);
  Image second = first;
  level(second, 401, 200, 0) = 10;
  const std::string text = difference_text(first, second, 64);
  EXPECT_EQ(std::count(text.begin(), text.end(), '.'), 1);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 18);
}

}  // namespace
}  // namespace thinwall
