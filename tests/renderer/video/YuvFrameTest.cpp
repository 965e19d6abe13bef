#include "renderer/video/YuvFrame.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/renderer/image/TestImages.hpp"

namespace thinwall {
namespace {

struct Yuv {
  int luma, blue, red;
  friend bool operator==(const Yuv&, const Yuv&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Yuv& c) {
    return out << c.luma << ' ' << c.blue << ' ' << c.red;
  }
};

Yuv of_plain(int red, int green, int blue) {
  const auto byte = [](int level) { return static_cast<std::uint8_t>(level); };
  const auto planes = yuv420_bt709(plain_image({2, 2}, byte(red), byte(green), byte(blue)));
  return {planes[0], planes[4], planes[5]};
}

/// The definition of ITU-R BT.709 in floating point.
Yuv by_definition(int red, int green, int blue) {
  const double luma = (0.2126 * red + 0.7152 * green + 0.0722 * blue) / 255;
  const double cb = (blue / 255.0 - luma) / 1.8556;
  const double cr = (red / 255.0 - luma) / 1.5748;
  const auto level = [](double value) { return static_cast<int>(std::floor(value + 0.5)); };
  return {level(16 + 219 * luma), level(128 + 224 * cb), level(128 + 224 * cr)};
}

TEST(YuvFrame, PureColoursHaveTheLumaOfBt709) {
  EXPECT_EQ(of_plain(255, 0, 0).luma, 63);
  EXPECT_EQ(of_plain(0, 255, 0).luma, 173);
  EXPECT_EQ(of_plain(0, 0, 255).luma, 32);
}

TEST(YuvFrame, RangeIsLimited) {
  EXPECT_EQ(of_plain(0, 0, 0), (Yuv{16, 128, 128}));
  EXPECT_EQ(of_plain(255, 255, 255), (Yuv{235, 128, 128}));
}

TEST(YuvFrame, GreyHasNoColour) {
  for (int level = 0; level < 256; ++level) {
    EXPECT_EQ(of_plain(level, level, level).blue, 128);
    EXPECT_EQ(of_plain(level, level, level).red, 128);
  }
}

TEST(YuvFrame, FollowsTheDefinitionOverTheColourCube) {
  for (int red = 0; red < 256; red += 15) {
    for (int green = 0; green < 256; green += 15) {
      for (int blue = 0; blue < 256; blue += 15) {
        const Yuv found = of_plain(red, green, blue);
        const Yuv wanted = by_definition(red, green, blue);
        // The 16-bit coefficients are off by up to 2^-17, so a level within 0.006 of a half may round the other way.
        ASSERT_LE(std::abs(found.luma - wanted.luma), 1);
        ASSERT_LE(std::abs(found.blue - wanted.blue), 1);
        ASSERT_LE(std::abs(found.red - wanted.red), 1);
      }
    }
  }
}

TEST(YuvFrame, PlanesLieBehindEachOther) {
  EXPECT_EQ(yuv420_bt709(plain_image({6, 4}, 9, 9, 9)).size(), 36u);
}

TEST(YuvFrame, ChromaSitsOnTheLeftColumn) {
  // A blue column 2 in black: chroma sample 1 sits on it and takes half of it; sample 0 is two columns away.
  Image image = plain_image({6, 2}, 0, 0, 0);
  for (const int row : {0, 1}) image.pixels[static_cast<std::size_t>(18 * row + 3 * 2 + 2)] = 255;
  const auto planes = yuv420_bt709(image);
  EXPECT_EQ(planes[12], 128);
  EXPECT_EQ(planes[13], 128 + 56);
  EXPECT_EQ(planes[14], 128);
  // In column 3 it is a quarter of both neighbours.
  image = plain_image({6, 2}, 0, 0, 0);
  for (const int row : {0, 1}) image.pixels[static_cast<std::size_t>(18 * row + 3 * 3 + 2)] = 255;
  const auto shifted = yuv420_bt709(image);
  EXPECT_EQ(shifted[13], 128 + 28);
  EXPECT_EQ(shifted[14], 128 + 28);
}

}  // namespace
}  // namespace thinwall
