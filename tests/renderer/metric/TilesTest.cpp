#include "renderer/metric/Tiles.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/renderer/image/TestImages.hpp"

namespace thinwall {
namespace {

TEST(Tiles, CoverEachPixelOnce) {
  std::vector<int> hits(70 * 45, 0);
  for (const PixelRegion& tile : tiles_of({70, 45}, 32)) {
    for (int y = tile.top; y < tile.bottom; ++y) {
      for (int x = tile.left; x < tile.right; ++x) ++hits[static_cast<std::size_t>(y * 70 + x)];
    }
  }
  EXPECT_EQ(hits, std::vector<int>(70 * 45, 1));
}

TEST(Tiles, GrowUpToThePicturesBorder) {
  const PixelRegion region = grown({0, 10, 20, 40}, 5, {70, 42});
  EXPECT_EQ(region.left, 0);
  EXPECT_EQ(region.top, 5);
  EXPECT_EQ(region.right, 25);
  EXPECT_EQ(region.bottom, 42);
}

TEST(Tiles, ADifferenceBelongsToItsRegionAlone) {
  const Image first = plain_image({10, 10}, 1, 2, 3);
  Image second = first;
  second.pixels[3 * (10 * 4 + 6) + 2] = 9;
  EXPECT_TRUE(differs_in(first, second, {6, 4, 7, 5}));
  EXPECT_FALSE(differs_in(first, second, {0, 0, 6, 10}));
  EXPECT_FALSE(differs_in(first, second, {7, 0, 10, 10}));
}

TEST(Tiles, EachIndexIsWorkedOnOnce) {
  std::vector<int> hits(1000, 0);
  for_each_in_parallel(
      hits.size(), [&](std::size_t i) { ++hits[i]; }, 4);
  EXPECT_EQ(hits, std::vector<int>(1000, 1));
}

TEST(Tiles, AFailureIsPassedOn) {
  const auto fail = [](std::size_t i) {
    if (i == 7) throw std::runtime_error("seven");
  };
  EXPECT_THROW(for_each_in_parallel(20, fail, 2), std::runtime_error);
}

}  // namespace
}  // namespace thinwall
