#include "renderer/metric/Drift.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/image/TestImages.hpp"
#include "tests/renderer/metric/MetricImages.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize{160, 110};

TEST(DriftTest, OfAPlainPictureIsTheChangeOfEachColor) {
  const Drift result = drift(plain_image({8, 4}, 100, 50, 200), plain_image({8, 4}, 101, 49, 200));
  EXPECT_DOUBLE_EQ(result.channels[0], 0.01);
  EXPECT_DOUBLE_EQ(result.channels[1], -0.02);
  EXPECT_DOUBLE_EQ(result.channels[2], 0);
  EXPECT_DOUBLE_EQ(result.largest(), 0.02);
}

TEST(DriftTest, DoesNotHangOnHowDarkAPictureIs) {
  const Image bright = shaded_image(kSize);
  // Darker still, and 8 bits cannot hold the hundredth any more.
  const Image dark = tinted(bright, 0.4, 0.4, 0.4);
  EXPECT_GT(drift(bright, tinted(bright, 1.01, 1.01, 1.01)).largest(), 0.005);
  EXPECT_GT(drift(dark, tinted(dark, 1.01, 1.01, 1.01)).largest(), 0.005);
}

TEST(DriftTest, OfRoundingThatGoesBothWaysIsNextToNothing) {
  const Image image = shaded_image(kSize);
  EXPECT_LT(drift(image, rounded_otherwise(image)).largest(), 1e-5);
}

TEST(DriftTest, OfABlackPictureIsInLevels) {
  EXPECT_DOUBLE_EQ(drift(plain_image({4, 4}, 0, 0, 0), plain_image({4, 4}, 2, 0, 0)).channels[0], 2);
}

}  // namespace
}  // namespace thinwall
