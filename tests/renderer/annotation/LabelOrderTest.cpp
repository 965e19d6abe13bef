#include "renderer/annotation/LabelOrder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace thinwall {
namespace {

const LabelRoom kRoom{.bounds = {20, 60, 600, 240}, .obstacles = {}, .gap = 8, .distance = 24};

LabelWish wish_to_order(double x, double y, bool left = false) {
  return {.anchor = {x, y}, .width = 90, .height = 30, .on_the_left = left};
}

int crossings(const std::vector<LabelWish>& wishes, const std::vector<std::size_t>& order, LabelRoom room = kRoom) {
  std::vector<LabelWish> ordered;
  for (const std::size_t i : order) {
    ordered.push_back(wishes[i]);
    room.obstacles.push_back(wishes[i].anchor);
  }
  return count_crossings(ordered, lay_out_labels(ordered, room));
}

TEST(LabelOrder, CountsPairsOfLeadersThatCross) {
  const std::vector<LabelWish> wishes = {wish_to_order(200, 100), wish_to_order(200, 200)};
  const Box above{300, 85, 90, 30}, below{300, 185, 90, 30};
  EXPECT_EQ(count_crossings(wishes, {above, below}), 0);
  EXPECT_EQ(count_crossings(wishes, {below, above}), 1);
}

TEST(LabelOrder, ALeaderRunsThroughABoxThatItCrossesOrEndsIn) {
  const Box box{100, 50, 80, 40};
  EXPECT_TRUE(runs_through({{90, 60}, {200, 80}}, box));
  EXPECT_TRUE(runs_through({{90, 60}, {110, 40}}, box)) << "over a corner";
  EXPECT_TRUE(runs_through({{120, 60}, {130, 70}}, box)) << "within";
  EXPECT_TRUE(runs_through({{120, 60}, {300, 300}}, box)) << "out of it";
  EXPECT_FALSE(runs_through({{90, 55}, {105, 40}}, box)) << "past a corner";
  EXPECT_FALSE(runs_through({{10, 60}, {90, 61}}, box)) << "towards it";
}

TEST(LabelOrder, ALeaderBeginsAtTheSideThatFacesItsPoint) {
  const Leader leader = leader_of(wish_to_order(200, 100), {300, 105, 90, 30});
  EXPECT_EQ(leader.from, (PixelPoint{300, 120}));
  EXPECT_EQ(leader.to, (PixelPoint{200, 100}));
}

TEST(LabelOrder, TheLeaderOfALabelThatReachesOverItsPointDoesNotPassUnderItsWords) {
  EXPECT_EQ(leader_of(wish_to_order(340, 160), {300, 105, 90, 30}).from, (PixelPoint{340, 135}));
  EXPECT_EQ(leader_of(wish_to_order(340, 80, true), {300, 105, 90, 30}).from, (PixelPoint{340, 105}));
  EXPECT_EQ(leader_of(wish_to_order(304, 160), {300, 105, 90, 30}).from, (PixelPoint{304, 124}))
      << "it gets there steadily";
}

TEST(LabelOrder, IsThatOfTheHeightsWhereNothingCrosses) {
  const std::vector<LabelWish> wishes = {wish_to_order(200, 250), wish_to_order(220, 90), wish_to_order(210, 170)};
  EXPECT_EQ(order_of_labels({{.wishes = wishes}}, kRoom), (std::vector<std::size_t>{1, 2, 0}));
}

TEST(LabelOrder, LeavesTheHeightsWhereTheyWouldMakeLeadersCross) {
  // At the lower bound the stack is pushed up, so that the line to the far point, whose label is the lower one, passes
  // over the near point.
  const std::vector<LabelWish> wishes = {wish_to_order(480, 296), wish_to_order(150, 298), wish_to_order(470, 299)};
  EXPECT_GT(crossings(wishes, {0, 1, 2}), 0);
  EXPECT_EQ(crossings(wishes, order_of_labels({{.wishes = wishes}}, kRoom)), 0);
}

/// Points all around and within a disc.
std::vector<PixelPoint> disc(double x, double y, double radius) {
  std::vector<PixelPoint> points;
  for (int i = 0; i < 4000; ++i) {
    const double turn = 2 * std::numbers::pi * std::fmod(i * std::numbers::phi, 1.0);
    const double reach = radius * std::sqrt((i + 0.5) / 4000);
    points.push_back({x + reach * std::cos(turn), y + reach * std::sin(turn)});
  }
  return points;
}

TEST(LabelOrder, NoneCrossWhereLabelsStandBesideAWideOrgan) {
  // The plates stand in a column beside the organ, far from what they point at, and above the lower bound.
  const LabelRoom room{.bounds = {26, 78, 1228, 434}, .obstacles = disc(640, 410, 272), .gap = 8, .distance = 26};
  const std::vector<LabelWish> wishes = {wish_to_order(627, 172), wish_to_order(640, 605), wish_to_order(853, 534),
                                         wish_to_order(416, 537)};
  const std::vector<std::size_t> order =
      order_of_labels({{.wishes = wishes, .outline = outline_of(room.obstacles, 8)}}, room);
  EXPECT_EQ(order.front(), 0U);
  EXPECT_EQ(crossings(wishes, order, room), 0);
}

TEST(LabelOrder, LeavesTheHeightsWhereALeaderWouldRunUnderAnotherLabel) {
  // In rows below the walls: over the second row, which is nearer to its point, lies a long label of a point farther
  // to the right.
  std::vector<LabelWish> wishes = {wish_to_order(300, 150, true), wish_to_order(200, 160, true)};
  wishes[0].width = 200;
  for (LabelWish& wish : wishes) wish.place = LabelPlace::kBelow;
  LabelRoom room = kRoom;
  room.walls_bottom = 200;
  const std::vector<PixelPoint> walls = {{320, 100}, {320, 200}};
  EXPECT_EQ(count_leaders_under_labels(wishes, lay_out_labels(wishes, room)), 1);
  EXPECT_EQ(order_of_labels({{.wishes = wishes, .outline = walls}}, room), (std::vector<std::size_t>{1, 0}));
  const std::vector<LabelWish> swapped = {wishes[1], wishes[0]};
  EXPECT_EQ(count_leaders_under_labels(swapped, lay_out_labels(swapped, room)), 0);
}

TEST(LabelOrder, ALabelLeavesItsPlaceWhereALeaderWouldRunUnderIt) {
  // The first, too wide to stand beside the walls, is above them, and its line passes where the other stands; below
  // them there is no room.
  std::vector<LabelWish> wishes = {wish_to_order(500, 200), wish_to_order(380, 150)};
  wishes[0].width = 200;
  wishes[0].place = LabelPlace::kAbove;
  wishes[1].width = 130;
  const std::vector<PixelPoint> walls = {{300, 140}, {500, 140}, {300, 280}, {500, 280}};
  const std::vector<LabelMoment> moments = {{.wishes = wishes, .outline = walls}};
  LabelRoom room = kRoom;
  room.obstacles = walls;
  room.walls_top = 140;
  room.walls_bottom = 280;
  EXPECT_EQ(count_leaders_under_labels(wishes, lay_out_labels(wishes, room)), 1);
  const LabelArrangement arrangement = arrange_labels(moments, kRoom);
  EXPECT_EQ(arrangement.places, (std::vector<LabelPlace>{LabelPlace::kAbove, LabelPlace::kAbove}));
  wishes[1].place = arrangement.places[1];
  const std::vector<LabelWish> ordered = {wishes[arrangement.order[0]], wishes[arrangement.order[1]]};
  EXPECT_EQ(count_leaders_under_labels(ordered, lay_out_labels(ordered, room)), 0);
}

TEST(LabelOrder, LabelsKeepTheirPlacesWhereNothingIsHidden) {
  std::vector<LabelWish> wishes = {wish_to_order(300, 150), wish_to_order(300, 200)};
  wishes[1].place = LabelPlace::kBelow;
  const std::vector<LabelMoment> moments = {{.wishes = wishes, .outline = {{300, 140}, {300, 220}}}};
  EXPECT_EQ(arrange_labels(moments, kRoom).places, (std::vector<LabelPlace>{LabelPlace::kBeside, LabelPlace::kBelow}));
}

TEST(LabelOrder, AnOutlineKeepsTheEndsOfEachRow) {
  EXPECT_EQ(outline_of({{5, 1}, {9, 2}, {7, 3}, {1, 9}, {4, 12}}, 8),
            (std::vector<PixelPoint>{{5, 1}, {9, 2}, {1, 9}, {4, 12}}));
}

TEST(LabelOrder, IsOneForAllMoments) {
  // Two points that turn about each other: no order is good at all times, and the one of most of them is kept.
  std::vector<LabelMoment> moments;
  for (const double turn : {-0.9, -0.3, 0.3, 0.6, 0.9}) {
    const double up = 60 * std::sin(turn * std::numbers::pi / 2);
    moments.push_back({.wishes = {wish_to_order(200, 180 + up), wish_to_order(200, 180 - up)}});
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
      wishes.push_back(wish_to_order(180 + 280 * x, 70 + 220 * y, x < 0.5));
    }
    EXPECT_EQ(crossings(wishes, order_of_labels({{.wishes = wishes}}, kRoom)), 0) << scene;
  }
}

}  // namespace
}  // namespace thinwall
