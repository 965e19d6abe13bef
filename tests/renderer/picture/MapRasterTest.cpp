#include "renderer/picture/MapRaster.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace thinwall {
namespace {

constexpr int kResolution = 32;

/// How often each texel is covered, (kResolution x kResolution).
std::vector<int> counts_of(const std::vector<std::array<MapCorner, 3>>& triangles) {
  std::vector<int> counts(std::size_t{kResolution} * kResolution);
  for (const auto& triangle : triangles) {
    for_spans(triangle, kResolution, [&](const MapSpan& span) {
      for (int x = span.first; x < span.end; ++x) ++counts[static_cast<std::size_t>(span.row * kResolution + x)];
    });
  }
  return counts;
}

TEST(MapRaster, CoversTheTexelsWhoseMiddlesAreInside) {
  // The diagonal runs from (2, 10) to (10, 2): x + y < 12 is inside.
  const std::vector<int> counts = counts_of({{MapCorner{2, 2, 0}, MapCorner{10, 2, 0}, MapCorner{2, 10, 0}}});
  for (int y = 0; y < kResolution; ++y) {
    for (int x = 0; x < kResolution; ++x) {
      if (x + y + 1 == 12) continue;  // on the diagonal
      const bool is_inside = x >= 2 && y >= 2 && x + y + 1 < 12;
      EXPECT_EQ(counts[static_cast<std::size_t>(y * kResolution + x)], is_inside ? 1 : 0) << x << ", " << y;
    }
  }
}

TEST(MapRaster, ValuesGoOnEvenlyWhateverTheOrderOfTheCorners) {
  const auto value = [](double x, double y) { return 3 + 0.25 * x - 0.5 * y; };
  const std::array<std::array<double, 2>, 3> places{{{3.3, 4.1}, {20.7, 9.2}, {11.4, 25.8}}};
  for (const auto& order : {std::array<std::size_t, 3>{0, 1, 2}, {2, 1, 0}, {1, 0, 2}, {1, 2, 0}}) {
    std::array<MapCorner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [x, y] = places[order[k]];
      corners[k] = {x, y, value(x, y)};
    }
    int texels = 0;
    for_spans(corners, kResolution, [&](const MapSpan& span) {
      for (int x = span.first; x < span.end; ++x, ++texels) {
        EXPECT_NEAR(span.value + (x - span.first) * span.step, value(x + 0.5, span.row + 0.5), 1e-9);
      }
    });
    EXPECT_NEAR(texels, 0.5 * (17.4 * 21.7 - 8.1 * 5.1), 12);
  }
}

TEST(MapRaster, TrianglesThatShareEdgesLeaveNoTexelOutAndShareNone) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-8, kResolution + 8);
  for (int turn = 0; turn < 200; ++turn) {
    const MapCorner middle{place(random), place(random), 0};
    const std::array<MapCorner, 4> around{MapCorner{-9, -9, 0}, MapCorner{kResolution + 9, -9, 0},
                                          MapCorner{kResolution + 9, kResolution + 9, 0},
                                          MapCorner{-9, kResolution + 9, 0}};
    std::vector<std::array<MapCorner, 3>> fan;
    for (std::size_t k = 0; k < 4; ++k) fan.push_back({middle, around[k], around[(k + 1) % 4]});
    for (const int count : counts_of(fan)) ASSERT_EQ(count, 1);
  }
}

TEST(MapRaster, WhatHasNoAreaOrLiesBesideTheMapCoversNothing) {
  for (const int count : counts_of({{MapCorner{3, 3, 0}, MapCorner{9, 9, 0}, MapCorner{6, 6, 0}},
                                    {MapCorner{3, 3, 0}, MapCorner{3, 3, 0}, MapCorner{3, 3, 0}},
                                    {MapCorner{-30, 3, 0}, MapCorner{-3, 3, 0}, MapCorner{-5, 20, 0}},
                                    {MapCorner{3, 40, 0}, MapCorner{30, 40, 0}, MapCorner{5, 90, 0}}})) {
    ASSERT_EQ(count, 0);
  }
}

}  // namespace
}  // namespace thinwall
