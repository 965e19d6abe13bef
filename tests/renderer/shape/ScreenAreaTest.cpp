#include "renderer/shape/ScreenArea.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/shape/RightAngle.hpp"

namespace thinwall {
namespace {

TEST(ScreenArea, ABoxFillsWhatItsNearestFaceCoversAndABorder) {
  const Bounds box{{-0.5F, -0.25F, -3}, {0.5F, 0.75F, -2}};
  // The near face spans a quarter of the picture to either side: 75 to 125 of 200; upwards from -1/8 to 3/8.
  const ScreenArea area = screen_area(box, right_angle(), {200, 160});
  EXPECT_EQ(area, (ScreenArea{74, 69, 52, 42}));
}

TEST(ScreenArea, WhatReachesBehindTheEyeMayBeSeenAnywhere) {
  const Bounds box{{-0.1F, -0.1F, -1}, {0.1F, 0.1F, 1}};
  EXPECT_EQ(screen_area(box, right_angle(), {200, 160}), (ScreenArea{0, 0, 200, 160}));
}

TEST(ScreenArea, OfATriangleThatReachesBehindTheEyeCountsWhatIsSeen) {
  std::vector<ToolVertex> vertices(3);
  vertices[0].position = {0, 0, -2};
  vertices[1].position = {0, 1, -2};
  vertices[2].position = {0.5F, 0, 1};
  // From the middle upwards by half of the upper half, and to the right on without end.
  const std::vector<std::uint32_t> corners = {0, 1, 2};
  const ScreenArea area = screen_area(vertices, corners, right_angle(), {200, 160});
  EXPECT_EQ(area.left, 99);
  EXPECT_EQ(area.left + area.width, 200);
  EXPECT_EQ(area.bottom, 79);
  // All of it behind the eye is not seen.
  for (ToolVertex& vertex : vertices) vertex.position[2] = 1;
  EXPECT_EQ(screen_area(vertices, corners, right_angle(), {200, 160}), ScreenArea{});
}

TEST(ScreenArea, WhatLiesBesideThePictureCoversNoMoreThanItsBorder) {
  const Bounds box{{5, 0, -2}, {6, 1, -1}};
  EXPECT_LE(screen_area(box, right_angle(), {200, 160}).width, 1);
}

TEST(ScreenArea, ABoxLiesAheadWhereNoCornerComesNearerThanTheNearPlane) {
  EXPECT_TRUE(lies_ahead({{-1, -1, -3}, {1, 1, -2}}, right_angle()));
  EXPECT_TRUE(lies_ahead({{5, 5, -3}, {6, 6, -2}}, right_angle())) << "beside the picture is ahead too";
  EXPECT_FALSE(lies_ahead({{-1, -1, -3}, {1, 1, -0.005F}}, right_angle()));
  EXPECT_FALSE(lies_ahead({{-1, -1, -1}, {1, 1, 1}}, right_angle())) << "the eye is inside";
}

TEST(ScreenArea, TheBoxAroundTwoHoldsBoth) {
  const Bounds bounds = around({{0, 0, 0}, {1, 1, 1}}, {{-1, 0.5F, 0.5F}, {0.5F, 2, 0.6F}});
  EXPECT_EQ(bounds.least, (Float3{-1, 0, 0}));
  EXPECT_EQ(bounds.most, (Float3{1, 2, 1}));
}

TEST(ScreenArea, TheAreaAroundTwoHoldsBothAndAnEmptyOneAddsNothing) {
  const ScreenArea first{10, 20, 5, 6}, second{2, 24, 9, 30}, none{};
  EXPECT_EQ(around(first, second), (ScreenArea{2, 20, 13, 34}));
  EXPECT_EQ(around(first, none), first);
  EXPECT_EQ(around(none, second), second);
}

TEST(ScreenArea, BoundsHoldEveryVertex) {
  std::vector<SurfaceVertex> vertices(3);
  vertices[0].position = {1, 2, 3};
  vertices[1].position = {-1, 5, 2};
  vertices[2].position = {0, 0, 7};
  const Bounds bounds = bounds_of(vertices);
  EXPECT_EQ(bounds.least, (Float3{-1, 0, 2}));
  EXPECT_EQ(bounds.most, (Float3{1, 5, 7}));
}

}  // namespace
}  // namespace thinwall
