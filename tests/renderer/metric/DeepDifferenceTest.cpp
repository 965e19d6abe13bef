#include "renderer/metric/DeepDifference.hpp"

#include <gtest/gtest.h>

#include "renderer/metric/ErrorPicture.hpp"
#include "tests/renderer/image/TestImages.hpp"

namespace thinwall {
namespace {

TEST(DeepDifference, APlainPictureComesBackFromItsDeepForm) {
  const Image image = patterned_image({31, 17});
  const DeepImage deep = deepened(image);
  EXPECT_TRUE(is_plain(deep));
  EXPECT_EQ(flattened(deep).pixels, image.pixels);
}

TEST(DeepDifference, FinerColorsAndTransparencyAreNotPlain) {
  DeepImage deep = deepened(plain_image({2, 2}, 10, 20, 30));
  deep.values[0] += 1;
  EXPECT_FALSE(is_plain(deep));
  deep.values[0] -= 1;
  deep.values[3] = 0;
  EXPECT_FALSE(is_plain(deep));
  EXPECT_EQ(flattened(deep).pixels[0], 255) << "what is transparent shows the white behind it";
}

TEST(DeepDifference, IsToldInLevels) {
  const DeepImage first = deepened(plain_image({2, 2}, 10, 20, 30));
  DeepImage second = first;
  second.values[5] += 257 * 3;
  EXPECT_EQ(compare_deep(first, first).largest, 0);
  EXPECT_DOUBLE_EQ(compare_deep(first, second).largest, 3);
  EXPECT_DOUBLE_EQ(compare_deep(first, second).mean, 3.0 / 16);
}

TEST(ErrorPicture, IsGreyWhereNothingIsSeenAndBrighterTheLargerTheError) {
  const Image picture = error_picture(plain_image({3, 1}, 200, 100, 100), {0, 0.3F, 1});
  EXPECT_EQ(picture.pixels[0], picture.pixels[1]);
  EXPECT_LT(picture.pixels[3] + picture.pixels[4] + picture.pixels[5],
            picture.pixels[6] + picture.pixels[7] + picture.pixels[8]);
}

}  // namespace
}  // namespace thinwall
