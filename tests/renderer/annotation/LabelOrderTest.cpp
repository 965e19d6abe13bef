#include "renderer/annotation/LabelOrder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace thinwall {
namespace {

const LabelRoom kRoom{.bounds = {20, 60, 600, 240}, .obstacles = {}, .gap = 8, .distance = 24};

LabelWish wish(double x, double y, bool left = false) {
  return {.anchor = {x, y}, .width = 90, .height = 30, .on_the_left = left};
}

int crossings(const std::vector<LabelWish>& wishes, const std::vector<std::size_t>& order) {
  std::vector<LabelWish> ordered;
  LabelRoom room = kRoom;
  for (const std::size_t i : order) {
    ordered.push_back(wishes[i]);
    room.obstacles.push_back(wishes[i].anchor);
  }
  return count_crossings(ordered, lay_out_labels(ordered, room));
}

TEST(LabelOrder, CountsPairsOfLeadersThatCross) {
  const std::vector<LabelWish> wishes = {wish(200, 100), wish(200, 200)};
  const Box above{300, 85, 90, 30}, below{300, 185, 90, 30};
  EXPECT_EQ(count_crossings(wishes, {above, below}), 0);
  EXPECT_EQ(count_crossings(wishes, {below, above}), 1);
}

TEST(LabelOrder, IsThatOfTheHeightsWhereNothingCrosses) {
  const std::vector<LabelWish> wishes = {wish(200, 250), wish(220, 90), wish(210, 170)};
  EXPECT_EQ(order_of_labels({wishes}, kRoom), (std::vector<std::size_t>{1, 2, 0}));
}

TEST(LabelOrder, LeavesTheHeightsWhereTheyWouldMakeLeadersCross) {
  // At the lower bound the stack is pushed up, so that the line to the far point, whose label is the lower one, passes
  // over the near point.
  const std::vector<LabelWish> wishes = {wish(480, 296), wish(150, 298), wish(470, 299)};
  EXPECT_GT(crossings(wishes, {0, 1, 2}), 0);
  EXPECT_EQ(crossings(wishes, order_of_labels({wishes}, kRoom)), 0);
}

TEST(LabelOrder, IsOneForAllMoments) {
  // Two points that turn about each other: no order is good at all times, and the one of most of them is kept.
  std::vector<std::vector<LabelWish>> moments;
  for (const double turn : {-0.9, -0.3, 0.3, 0.6, 0.9}) {
    const double up = 60 * std::sin(turn * std::numbers::pi / 2);
    moments.push_back({wish(200, 180 + up), wish(200, 180 - up)});
  }
  EXPECT_EQ(order_of_labels(moments, kRoom), (std::vector<std::size_t>{1, 0}));
}

TEST(LabelOrder, NoneCrossAmongPointsAnywhereOnTwoSides) {
  // A fixed sequence of places (multiples of irrational numbers).
  for (int scene = 0; scene < 60; ++scene) {
    std::vector<LabelWish> wishes;
    for (int i = 0; i < 6; ++i) {
      const double x = std::fmod((7 * scene + i + 1) * std::numbers::phi, 1.0);
      const double y = std::fmod((7 * scene + i + 1) * std::numbers::sqrt2, 1.0);
      wishes.push_back(wish(180 + 280 * x, 70 + 220 * y, x < 0.5));
    }
    EXPECT_EQ(crossings(wishes, order_of_labels({wishes}, kRoom)), 0) << scene;
  }
}

}  // namespace
}  // namespace thinwall
