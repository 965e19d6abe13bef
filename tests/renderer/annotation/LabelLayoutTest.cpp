#include "renderer/annotation/LabelLayout.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thinwall {
namespace {

constexpr Box kLayoutBounds{20, 60, 600, 240};

/// A disc in the middle of the bounds.
std::vector<PixelPoint> disc(double radius) {
  std::vector<PixelPoint> points;
  for (int i = 0; i < 720; ++i) {
    const double angle = i * 3.14159265358979 / 360;
    points.push_back({320 + radius * std::cos(angle), 180 + radius * std::sin(angle)});
  }
  return points;
}

LabelWish wish(double x, double y, bool left) {
  return {.anchor = {x, y}, .width = 90, .height = 30, .on_the_left = left};
}

TEST(LabelLayout, ALabelStandsLevelWithItsAnchorBesideTheObstacles) {
  const auto boxes = lay_out_labels({wish(300, 180, true), wish(340, 180, false)},
                                    {.bounds = kLayoutBounds, .obstacles = disc(100), .gap = 8, .distance = 24});
  EXPECT_NEAR(boxes[0].y + 15, 180, 1e-9);
  EXPECT_NEAR(boxes[0].right(), 220 - 24, 0.1);
  EXPECT_NEAR(boxes[1].x, 420 + 24, 0.1);
}

TEST(LabelLayout, LabelsOfOneSideAreOrderedApartAndAsNearToTheirAnchorsAsCanBe) {
  const auto boxes = lay_out_labels({wish(300, 170, true), wish(300, 172, true), wish(300, 180, true)},
                                    {.bounds = kLayoutBounds, .obstacles = disc(50), .gap = 8, .distance = 24});
  // Three stacked at a pitch of 38 with the mean of their anchors, 174, in the middle.
  EXPECT_NEAR(boxes[0].y + 15, 174 - 38, 1e-9);
  EXPECT_NEAR(boxes[1].y + 15, 174, 1e-9);
  EXPECT_NEAR(boxes[2].y + 15, 174 + 38, 1e-9);
}

TEST(LabelLayout, LabelsStayInsideTheBounds) {
  std::vector<LabelWish> wishes;
  for (int i = 0; i < 6; ++i) wishes.push_back(wish(100, 290 + i, i % 2 == 0));
  const auto boxes =
      lay_out_labels(wishes, {.bounds = kLayoutBounds, .obstacles = disc(110), .gap = 8, .distance = 24});
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_GE(boxes[i].x, kLayoutBounds.x);
    EXPECT_GE(boxes[i].y, kLayoutBounds.y);
    EXPECT_LE(boxes[i].right(), kLayoutBounds.right());
    EXPECT_LE(boxes[i].bottom(), kLayoutBounds.bottom() + 1e-9);
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(boxes[i].overlaps(boxes[k])) << i << " and " << k;
  }
}

TEST(LabelLayout, CoversNoObstacleWhereThereIsRoom) {
  const auto obstacles = disc(110);
  for (double y = 80; y < 290; y += 7) {
    for (const bool left : {true, false}) {
      const Box box = lay_out_labels({wish(320, y, left)}, {.bounds = kLayoutBounds, .obstacles = obstacles})[0];
      for (const PixelPoint& point : obstacles) {
        EXPECT_FALSE(point[0] > box.x && point[0] < box.right() && point[1] > box.y && point[1] < box.bottom()) << y;
      }
    }
  }
}

TEST(LabelLayout, MovesSteadily) {
  const auto obstacles = disc(110);
  Box before =
      lay_out_labels({wish(320, 80, true), wish(320, 180, true)}, {.bounds = kLayoutBounds, .obstacles = obstacles})[0];
  for (double y = 80; y < 290; y += 0.25) {
    const auto boxes =
        lay_out_labels({wish(320, y, true), wish(320, 180, true)}, {.bounds = kLayoutBounds, .obstacles = obstacles});
    // The edge yields by at most 2 pixels across for one up or down.
    EXPECT_LE(std::abs(boxes[0].x - before.x), 0.5 + 1e-9) << y;
    EXPECT_LE(std::abs(boxes[0].y - before.y), 0.25 + 1e-9) << y;
    before = boxes[0];
  }
}

TEST(LabelLayout, LabelsKeepClearOfWhatIsTakenInAnyCorner) {
  for (const Box& taken :
       {Box{20, 60, 190, 110}, Box{430, 60, 190, 110}, Box{20, 190, 190, 110}, Box{430, 190, 190, 110}}) {
    // Up to eight on a side are too many for the heights that are left.
    for (int count = 1; count <= 16; ++count) {
      std::vector<LabelWish> wishes;
      for (int i = 0; i < count; ++i) wishes.push_back(wish(320, 70 + 220.0 * i / count, i % 2 == 0));
      const auto boxes = lay_out_labels(
          wishes, {.bounds = kLayoutBounds, .obstacles = disc(110), .gap = 8, .distance = 24, .taken = {taken}});
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_FALSE(boxes[i].overlaps(taken)) << taken.x << ' ' << taken.y << ": " << i << " of " << count;
        EXPECT_GE(boxes[i].x, kLayoutBounds.x);
        EXPECT_LE(boxes[i].right(), kLayoutBounds.right());
      }
    }
  }
}

TEST(LabelLayout, OnTheSideOfWhatIsTakenALabelStandsBelowItAndBesideTheObstacles) {
  const auto boxes = lay_out_labels(
      {wish(220, 100, true)},
      {.bounds = kLayoutBounds, .obstacles = disc(100), .gap = 8, .distance = 24, .taken = {Box{20, 60, 190, 110}}});
  EXPECT_NEAR(boxes[0].y, 178, 1e-9);
  EXPECT_NEAR(boxes[0].right(), 220 - 24, 0.5);
}

TEST(LabelLayout, WhereTheOtherSideIsTooNarrowItsLabelsKeepTheirHeightsClearToo) {
  const Box narrow{20, 60, 280, 240}, taken{20, 60, 220, 100};
  const auto boxes = lay_out_labels({wish(100, 80, false), wish(150, 90, true)},
                                    {.bounds = narrow, .obstacles = {}, .gap = 8, .distance = 24, .taken = {taken}});
  for (const Box& box : boxes) {
    EXPECT_FALSE(box.overlaps(taken));
    EXPECT_LE(box.right(), narrow.right());
  }
}

TEST(LabelLayout, ALabelThatTheBoundsPressOverItsAnchorStandsAboveOrBelowIt) {
  // As of an organ that fills the picture.
  for (const bool left : {true, false}) {
    for (const bool upwards : {true, false}) {
      LabelWish wanted = wish(left ? 80 : 560, 180, left);
      wanted.upwards = upwards;
      const Box box =
          lay_out_labels({wanted}, {.bounds = kLayoutBounds, .obstacles = disc(310), .gap = 8, .distance = 24})[0];
      EXPECT_NEAR(upwards ? 180 - box.bottom() : box.y - 180, 12, 1e-9);
    }
  }
}

TEST(LabelLayout, ALabelThatIsPressedOverItsAnchorGetsThereSteadily) {
  Box before;
  for (double x = 200; x > 40; x -= 0.25) {
    const Box box = lay_out_labels({wish(x, 180, true)}, {.bounds = kLayoutBounds, .obstacles = {{x, 180}}})[0];
    if (x < 200) {
      // By 27 pixels while the anchor comes nearer by the gap.
      EXPECT_LE(std::abs(box.y - before.y), 1) << x;
      EXPECT_LE(std::abs(box.x - before.x), 0.25 + 1e-9) << x;
    }
    before = box;
  }
}

/// Whether any label covers a point that one of them points at, dot included.
bool covers_a_point(const std::vector<LabelWish>& wishes, const std::vector<Box>& boxes) {
  constexpr double kDot = 3;
  for (const Box& box : boxes) {
    for (const LabelWish& label : wishes) {
      const auto [x, y] = label.anchor;
      if (x > box.x - kDot && x < box.right() + kDot && y > box.y - kDot && y < box.bottom() + kDot) return true;
    }
  }
  return false;
}

TEST(LabelLayout, StackedLabelsThatTheBoundsPressOverTheirAnchorsDoNotBringEachOtherBackOverThem) {
  // As near the upper left corner of half a picture. Apart, each would stand 12 below its anchor; two so close
  // together are 14 higher and lower.
  std::vector<LabelWish> wishes = {wish(70, 120, true), wish(70, 130, true)};
  for (LabelWish& wanted : wishes) wanted.upwards = false;
  const LabelRoom room{.bounds = kLayoutBounds, .obstacles = disc(310), .gap = 8, .distance = 24};
  const std::vector<Box> boxes = lay_out_labels(wishes, room);
  EXPECT_FALSE(covers_a_point(wishes, boxes));
  EXPECT_GE(boxes[1].y, boxes[0].bottom() + 8 - 1e-9);
}

TEST(LabelLayout, ALabelThatHasNoRoomAboveItsAnchorStandsBelowIt) {
  // The way of a camera has brought the point of a low label up to the bound.
  for (const double y : {65, 90}) {
    const std::vector<LabelWish> wishes = {wish(70, y, true)};
    const std::vector<Box> boxes =
        lay_out_labels(wishes, {.bounds = kLayoutBounds, .obstacles = disc(310), .gap = 8, .distance = 24});
    EXPECT_FALSE(covers_a_point(wishes, boxes)) << y;
    EXPECT_NEAR(boxes[0].y - y, 12, 1e-9);
  }
}

TEST(LabelLayout, ALabelIsNotPressedOverThePointOfAnother) {
  // The first would stand below its own point, where the other's is.
  std::vector<LabelWish> wishes = {wish(70, 150, true), wish(60, 175, true)};
  wishes[0].upwards = false;
  wishes[1].upwards = false;
  const LabelRoom room{.bounds = kLayoutBounds, .obstacles = disc(310), .gap = 8, .distance = 24};
  EXPECT_FALSE(covers_a_point(wishes, lay_out_labels(wishes, room)));
}

/// Bounds higher than wide, with a disc as wide as they are but for 40 at each side.
LabelRoom high_room() {
  LabelRoom room{.bounds = {180, -120, 280, 600}, .obstacles = disc(100), .gap = 8, .distance = 24};
  room.walls_top = 80;
  room.walls_bottom = 280;
  return room;
}

TEST(LabelLayout, ALabelWithoutRoomBesideTheWallsStandsAboveOrBelowThemWhicheverIsNearer) {
  EXPECT_EQ(roomy_place(wish(320, 150, true), high_room()), LabelPlace::kAbove);
  EXPECT_EQ(roomy_place(wish(320, 210, true), high_room()), LabelPlace::kBelow);
  EXPECT_EQ(roomy_place(wish(320, 80, true), high_room()), LabelPlace::kBeside) << "the disc is narrow at its top";
  LabelRoom low = high_room();
  low.bounds.height = 420;
  EXPECT_EQ(roomy_place(wish(320, 210, true), low), LabelPlace::kAbove) << "20 below";
  low.bounds.y = 60;
  low.bounds.height = 240;
  EXPECT_EQ(roomy_place(wish(320, 150, true), low), LabelPlace::kBeside) << "20 above and below";
  LabelRoom near = high_room();
  near.walls_top = -60;  // 300 above: half of the height of the bounds
  near.walls_bottom = 560;
  EXPECT_EQ(roomy_place(wish(320, 235, true), near), LabelPlace::kAbove);
  EXPECT_EQ(roomy_place(wish(320, 245, true), near), LabelPlace::kBeside) << "the way is too long";
  LabelRoom wide = high_room();
  wide.bounds = kLayoutBounds;
  EXPECT_EQ(roomy_place(wish(320, 150, true), wide), LabelPlace::kBeside);
}

TEST(LabelLayout, LabelsAboveAndBelowTheWallsStandInRowsAwayFromThemAndBesideTools) {
  LabelRoom room = high_room();
  for (double y = -120; y < 80; y += 5) room.tools.push_back({330, y});
  std::vector<LabelWish> wishes = {wish(310, 260, false), wish(310, 100, false), wish(312, 250, false),
                                   wish(312, 110, false)};
  for (const std::size_t k : {0U, 2U}) wishes[k].place = LabelPlace::kBelow;
  for (const std::size_t k : {1U, 3U}) wishes[k].place = LabelPlace::kAbove;
  const auto boxes = lay_out_labels(wishes, room);
  EXPECT_NEAR(boxes[3].bottom(), 80 - 24, 1e-9);
  EXPECT_NEAR(boxes[1].bottom(), 80 - 24 - 38, 1e-9);
  EXPECT_NEAR(boxes[0].y, 280 + 24, 1e-9);
  EXPECT_NEAR(boxes[2].y, 280 + 24 + 38, 1e-9);
  for (const std::size_t k : {1U, 3U}) EXPECT_NEAR(boxes[k].x, 330 + 24, 1e-9) << "beside the tool";
  for (const std::size_t k : {0U, 2U}) EXPECT_NEAR(boxes[k].x, wishes[k].anchor[0] + 24, 1e-9) << "beside its anchor";
}

TEST(LabelLayout, LabelsKeepTheirHeightsBesideALegend) {
  const Box legend{20, 60, 70, 240};
  const auto boxes =
      lay_out_labels({wish(250, 100, true), wish(250, 200, true)},
                     {.bounds = kLayoutBounds, .obstacles = disc(100), .gap = 8, .distance = 24, .taken = {legend}});
  EXPECT_NEAR(boxes[0].y + 15, 100, 1e-9);
  EXPECT_NEAR(boxes[1].y + 15, 200, 1e-9);
  for (const Box& box : boxes) EXPECT_GE(box.x, legend.right() + 8);
}

TEST(LabelLayout, LabelsKeepClearOfALegendAtOneSideAndOfAPictureAtTheOther) {
  const Box legend{20, 60, 70, 200}, picture{430, 60, 190, 110};
  std::vector<LabelWish> wishes;
  for (int i = 0; i < 8; ++i) wishes.push_back(wish(320, 80 + 25.0 * i, i % 2 == 0));
  const auto boxes = lay_out_labels(
      wishes, {.bounds = kLayoutBounds, .obstacles = disc(110), .gap = 8, .distance = 24, .taken = {picture, legend}});
  for (const Box& box : boxes) {
    EXPECT_FALSE(box.overlaps(legend));
    EXPECT_FALSE(box.overlaps(picture));
  }
}

TEST(LabelLayout, ALabelPassesTheEndOfALegendSteadily) {
  LabelRoom room{.bounds = kLayoutBounds, .obstacles = {}, .gap = 8, .distance = 24, .taken = {{20, 60, 70, 100}}};
  for (double y = 60; y < 300; y += 5) room.obstacles.push_back({180, y});
  double before = 66;
  for (double y = 280; y > 100; y -= 0.25) {
    const Box box = lay_out_labels({wish(300, y, true)}, room)[0];
    EXPECT_LE(std::abs(box.x - before), 0.5 + 1e-9) << y;
    EXPECT_FALSE(box.overlaps(room.taken[0])) << y;
    before = box.x;
  }
  EXPECT_NEAR(before, 98, 1e-9) << "beside it";
}

}  // namespace
}  // namespace thinwall
