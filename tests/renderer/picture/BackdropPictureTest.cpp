#include "renderer/picture/BackdropPicture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace thinwall {
namespace {

/// A small picture whose levels grow evenly across and upwards.
std::vector<std::uint8_t> slope(ImageSize size, int across, int up) {
  std::vector<std::uint8_t> pixels;
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column) {
      const auto level = static_cast<std::uint8_t>(10 + across * column + up * row);
      pixels.insert(pixels.end(), {level, level, 200, 255});
    }
  }
  return pixels;
}

TEST(BackdropPicture, ASlopeStaysASlopeWithinHalfALevelAndTheNoise) {
  const ImageSize small{40, 20}, size{160, 80};
  BackdropPicture backdrop(small, size);
  const auto pixels = backdrop.enlarge(slope(small, 4, 3), {});
  ASSERT_EQ(pixels.size(), 4U * 160 * 80);
  for (int row = 2; row < 78; ++row) {
    for (int column = 2; column < 158; ++column) {
      const std::uint8_t* pixel = pixels.data() + 4 * (160 * row + column);
      const double wanted = 10 + 4 * ((column + 0.5) / 4 - 0.5) + 3 * ((row + 0.5) / 4 - 0.5);
      // Half a level of rounding, half of noise, and what whole numbers with seven bits behind the point lose.
      ASSERT_NEAR(pixel[0], wanted, 1.05) << column << ", " << row;
      ASSERT_NEAR(pixel[2], 200, 1);
      ASSERT_EQ(pixel[3], 255);
    }
  }
}

TEST(BackdropPicture, TheNoiseChangesNoMean) {
  const ImageSize small{32, 32}, size{128, 128};
  BackdropPicture backdrop(small, size);
  const std::vector<std::uint8_t> even = slope(small, 0, 0);
  double sum = 0;
  const auto pixels = backdrop.enlarge(even, {});
  for (std::size_t i = 0; i < pixels.size(); i += 4) sum += pixels[i];
  EXPECT_NEAR(sum / (128 * 128), 10, 0.02);
}

TEST(BackdropPicture, ASizeThatIsNoMultipleReachesFromBorderToBorder) {
  const ImageSize small{5, 3}, size{17, 11};
  BackdropPicture backdrop(small, size);
  const auto pixels = backdrop.enlarge(slope(small, 20, 0), {});
  for (int row = 0; row < 11; ++row) {
    EXPECT_NEAR(pixels[4 * (17 * static_cast<std::size_t>(row))], 10, 1);
    EXPECT_NEAR(pixels[4 * (17 * static_cast<std::size_t>(row) + 16)], 90, 1);
  }
}

TEST(BackdropPicture, WhatHasBeenEnlargedBeforeLeavesNothingBehind) {
  const ImageSize small{40, 20}, size{160, 80};
  const FieldStop wide{.tangent = 0.7, .half_field = {0.8, 0.4}}, narrow{.tangent = 0.5, .half_field = {0.8, 0.4}};
  const std::vector<std::uint8_t> first = slope(small, 4, 3);
  std::vector<std::uint8_t> second = first;
  for (const int row : {0, 7, 8, 19}) second[4 * (40 * static_cast<std::size_t>(row) + 21)] = 200;
  BackdropPicture used(small, size);
  const std::pair<const std::vector<std::uint8_t>*, FieldStop> pictures[] = {
      {&first, wide}, {&second, wide}, {&first, narrow}, {&first, {}}, {&first, {}}, {&second, {}}};
  for (const auto& [picture, stop] : pictures) {
    const auto again = used.enlarge(*picture, stop);
    BackdropPicture fresh(small, size);
    EXPECT_TRUE(std::ranges::equal(again, fresh.enlarge(*picture, stop)));
  }
}

TEST(BackdropPicture, NothingIsSeenOutsideAFieldStopAndAllWithinIt) {
  const ImageSize small{40, 20}, size{160, 80};
  BackdropPicture backdrop(small, size);
  const FieldStop stop{.tangent = 0.5, .half_field = {0.8, 0.4}};
  const auto pixels = backdrop.enlarge(slope(small, 0, 0), stop);
  int lit = 0, dark = 0;
  for (int row = 0; row < 80; ++row) {
    for (int column = 0; column < 160; ++column) {
      const double x = (column + 0.5) / 80 - 1, y = (row + 0.5) / 40 - 1;
      const double radius = std::hypot(0.8 * x, 0.4 * y) / 0.5;
      const int blue = pixels[4 * (160 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)) + 2];
      if (radius < 0.98) {
        ++lit;
        EXPECT_NEAR(blue, 200, 1) << column << ", " << row;
      }
      if (radius > 1) {
        ++dark;
        EXPECT_EQ(blue, 0) << column << ", " << row;
      }
    }
  }
  EXPECT_GT(lit, 3000);
  EXPECT_GT(dark, 3000);
}

TEST(BackdropPicture, OutsideTheAreaWithinAFieldStopNothingIsShown) {
  const ImageSize small{40, 20}, size{160, 80};
  for (const double tangent : {0.13, 0.31, 0.5, 0.77}) {
    const FieldStop stop{.tangent = tangent, .half_field = {0.8, 0.4}};
    const ScreenArea area = area_within(stop, small);
    EXPECT_LT(area.width, tangent < 0.7 ? 40 : 41);
    const std::vector<std::uint8_t> drawn = slope(small, 4, 3);
    std::vector<std::uint8_t> within = drawn;
    for (int row = 0; row < 20; ++row) {
      for (int column = 0; column < 40; ++column) {
        const bool is_inside = column >= area.left && column < area.left + area.width && row >= area.bottom &&
                               row < area.bottom + area.height;
        if (!is_inside) within[4 * (40 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column))] = 255;
      }
    }
    BackdropPicture whole(small, size), part(small, size);
    EXPECT_TRUE(std::ranges::equal(whole.enlarge(drawn, stop), part.enlarge(within, stop))) << tangent;
  }
  EXPECT_EQ(area_within({}, small), (ScreenArea{0, 0, 40, 20}));
}

}  // namespace
}  // namespace thinwall
