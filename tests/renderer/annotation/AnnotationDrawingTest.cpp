#include "renderer/annotation/AnnotationDrawing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/camera/Camera.hpp"
#include "renderer/overlay/LegendPlate.hpp"
#include "renderer/overlay/Overlay.hpp"
#include "tests/renderer/annotation/AnnotatedScenes.hpp"

namespace thinwall {
namespace {

TEST(AnnotationDrawing, ALabelsDotIsWhereItsMaterialPointIsSeen) {
  for (const double stretch : {1.0, 1.3}) {
    Snapshot snapshot = scene(stretch);
    snapshot.time = 1;
    // A vertex of the sphere, which stretches along x.
    const double side = 0.02 * std::sqrt(0.5);
    const Image image = drawn(label_at({side, -side, 0}), snapshot);
    const Camera camera = resolve_camera(from_the_front(), scene_extent(snapshot), kSize, 1);
    const auto pixel = camera.pixel({side * stretch, -side, 0}, kSize);
    ASSERT_TRUE(pixel);
    EXPECT_GT(level(image, (*pixel)[0], (*pixel)[1]), 220);
    EXPECT_EQ(level(image, (*pixel)[0] - 12, (*pixel)[1]), 0) << "the leader goes the other way";
  }
}

TEST(AnnotationDrawing, ALabelNearABorderStandsTowardsItThoughTheOrgansMiddleIsNearerToThat) {
  Snapshot snapshot = scene();
  snapshot.time = 1;
  CameraDefinition camera = from_the_front();
  for (auto* place : {&*camera.position, &*camera.target}) (*place)[0] += 0.05;
  const double side = 0.02 * std::sqrt(0.5);
  Image image = black();
  draw_annotations(image, {.size = kSize}, label_at({side, -side, 0}), snapshot, camera);
  const auto pixel = resolve_camera(camera, scene_extent(snapshot), kSize, 1).pixel({side, -side, 0}, kSize);
  ASSERT_TRUE(pixel);
  EXPECT_GT(level(image, (*pixel)[0], (*pixel)[1]), 220);
  int lit_left = 0, lit_right = 0;  // beside the dot
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      if (std::abs(x - (*pixel)[0]) > 12 && level(image, x + 0.5, y + 0.5) > 100)
        ++(x < (*pixel)[0] ? lit_left : lit_right);
    }
  }
  EXPECT_GT(lit_left, 200);
  EXPECT_EQ(lit_right, 0);
}

TEST(AnnotationDrawing, APointBehindAWallHasAHollowDot) {
  Snapshot snapshot = scene();
  snapshot.time = 1;
  const Image image = drawn(label_at({0, 0.02, 0}), snapshot);
  EXPECT_LT(level(image, 0.5 * kSize.width, 0.5 * kSize.height), 60);
  EXPECT_GT(level(image, 0.5 * kSize.width - 4, 0.5 * kSize.height), 120);
}

TEST(AnnotationDrawing, APointBehindAToolHasAHollowDot) {
  Snapshot snapshot = scene();
  snapshot.time = 1;
  snapshot.tools[0].kind = SnapshotToolKind::kSphere;
  snapshot.tools[0].radius = 0.005;
  snapshot.tools[0].tip = {0, -0.025, -0.005};
  const Image image = drawn(label_at({0, -0.02, 0}), snapshot);
  EXPECT_LT(level(image, 0.5 * kSize.width, 0.5 * kSize.height), 60);
}

TEST(AnnotationDrawing, ALabelIsShownInItsSpanOnly) {
  for (const auto& [time, shown] :
       {std::pair{0.49, false}, std::pair{0.5, true}, std::pair{2.0, true}, std::pair{2.01, false}}) {
    Snapshot snapshot = scene();
    snapshot.time = time;
    EXPECT_EQ(drawn(label_at({0.02, 0, 0}), snapshot).pixels != black().pixels, shown) << time;
  }
}

TEST(AnnotationDrawing, WhatTheFieldStopCoversHasNoLabel) {
  Snapshot snapshot = scene();
  snapshot.time = 1;
  CameraDefinition camera = from_the_front();
  camera.target = Double3{-0.035, 0, 0};  // the point lies near the right border, beyond the round picture
  for (const CameraKind kind : {CameraKind::kPinhole, CameraKind::kEndoscope}) {
    camera.kind = kind;
    Image image = black();
    draw_annotations(image, {.size = kSize}, label_at({0.01414, -0.01414, 0}), snapshot, camera);
    EXPECT_EQ(image.pixels != black().pixels, kind == CameraKind::kPinhole);
  }
}

TEST(AnnotationDrawing, LeavesAnInsetInAnyCornerAsItIs) {
  Snapshot snapshot = scene();
  snapshot.time = 1;
  AnnotationDefinition annotations;
  for (const double side : {-1.0, 1.0}) {
    for (const double height : {-0.018, 0.0, 0.018}) {
      annotations.labels.push_back({.text = "A long name of a part", .body = "organ", .at = {side * 0.02, 0, height}});
      annotations.arrows.push_back({.text = "Press", .body = "organ", .at = {side * 0.02, 0, height}, .length = 0.05});
    }
  }
  for (const PictureCorner corner :
       {PictureCorner::kUpperLeft, PictureCorner::kUpperRight, PictureCorner::kLowerLeft, PictureCorner::kLowerRight}) {
    const PictureBox inset = inset_box({.corner = corner}, kSize);
    Image image = black();
    draw_annotations(image, {.size = kSize}, annotations, snapshot, from_the_front(), inset);
    EXPECT_NE(image.pixels, black().pixels);
    int changed = 0;
    for (int y = inset.top; y < inset.top + inset.size.height; ++y) {
      for (int x = inset.left; x < inset.left + inset.size.width; ++x) changed += level(image, x + 0.5, y + 0.5) > 0;
    }
    EXPECT_EQ(changed, 0);
  }
}

TEST(AnnotationDrawing, LabelsAndTextsOfArrowsKeepClearOfALegend) {
  Snapshot snapshot = scene(1.9);  // nearly up to the legend
  snapshot.time = 1;
  AnnotationDefinition annotations;
  for (const double height : {-0.012, 0.0, 0.012}) {
    annotations.labels.push_back({.text = "A long name of a part", .body = "organ", .at = {0.016, 0, height}});
  }
  annotations.arrows.push_back({.text = "A long text beside", .body = "organ", .at = {0.016, 0, 0.012}});
  const Box legend =
      legend_place(OverlayGrid(kSize), {0, 0, kSize.width, kSize.height}, PictureCorner::kUpperRight, {});
  const auto inked = [&](const std::optional<Box>& told) {
    Image image = black();
    const std::vector<Box> taken = told ? std::vector<Box>{*told} : std::vector<Box>{};
    draw_annotations(image, {.size = kSize}, annotations, snapshot, from_the_front(), {}, taken);
    int count = 0;
    for (int y = static_cast<int>(legend.y); y < legend.bottom(); ++y) {
      for (int x = static_cast<int>(legend.x); x < legend.right(); ++x) count += level(image, x + 0.5, y + 0.5) > 0;
    }
    return count;
  };
  EXPECT_GT(inked({}), 1000) << "they would stand there";
  EXPECT_EQ(inked(legend), 0);
}

TEST(AnnotationDrawing, DigitsAreReadOverTheLinesOfLabelsAndDotsSeenOverDigits) {
  Snapshot snapshot = scene();
  snapshot.time = 1;
  CameraDefinition camera = from_the_front();
  for (auto* place : {&*camera.position, &*camera.target}) {
    (*place)[0] += 0.036;
    (*place)[2] += 0.019;
  }
  const Double3 at{0, -0.02, 0};
  const auto dot = resolve_camera(camera, scene_extent(snapshot), kSize, 1).pixel({at[0], at[1], at[2]}, kSize);
  ASSERT_TRUE(dot);
  OverlayContent content;
  content.tool = "probe";
  content.phase = "contact";
  content.force = 0.888;
  Image without = black();
  draw_overlay(without, content);
  const AnnotationLayers layers(kSize, {.size = kSize}, label_at(at), snapshot, camera);
  Image with = black();
  layers.lay_lines(with);
  Image lines = with;
  draw_overlay(with, content);
  layers.lay_points(with);
  constexpr int kGaugeRight = 270, kGaugeTop = 546, kGaugeBottom = 694;
  int crossed = 0, darkened = 0;
  for (int y = kGaugeTop; y < kGaugeBottom; ++y) {
    for (int x = 26; x < kGaugeRight; ++x) {
      if (std::hypot(x - (*dot)[0], y - (*dot)[1]) < 9) continue;
      crossed += level(lines, x + 0.5, y + 0.5) > 200;
      darkened += level(with, x + 0.5, y + 0.5) < level(without, x + 0.5, y + 0.5) - 1;
    }
  }
  EXPECT_GT(crossed, 30) << "the line crosses the gauge";
  EXPECT_EQ(darkened, 0);
  EXPECT_GT(level(with, (*dot)[0], (*dot)[1]), 220);
}

TEST(AnnotationDrawing, LabelsLeaveAnOrganFreeInAHighPicture) {
  constexpr ImageSize kHigh{400, 720};
  Snapshot snapshot = scene();
  snapshot.time = 1;
  snapshot.tools.clear();
  CameraDefinition camera = from_the_front();
  camera.position = Double3{0, -0.25, 0};
  AnnotationDefinition annotations;
  for (const double height : {-0.006, 0.006}) {
    annotations.labels.push_back({.text = "A long name of a part", .body = "organ", .at = {0.004, -0.019, height}});
  }
  Image image{.size = kHigh, .pixels = std::vector<std::uint8_t>(3UL * kHigh.width * kHigh.height, 0)};
  draw_annotations(image, {.size = kHigh}, annotations, snapshot, camera);
  // The ball is seen with a radius of 107 pixels.
  std::size_t inked = 0, covered = 0;
  for (int y = 0; y < kHigh.height; ++y) {
    for (int x = 0; x < kHigh.width; ++x) {
      if (image.pixels[3 * static_cast<std::size_t>(y * kHigh.width + x)] == 0) continue;
      ++inked;
      covered += std::hypot(x - 200, y - 360) < 107;
    }
  }
  EXPECT_GT(inked, 4000U) << "two plates";
  // Two lines of up to 107 pixels, three wide with their rims, and two dots.
  EXPECT_LT(covered, 900U);
}

TEST(AnnotationDrawing, LabelsKeepAboveCaptionsThatStandAbovePanels) {
  constexpr ImageSize kNarrow{960, 720};
  Snapshot snapshot = scene();
  snapshot.time = 1;
  Image image{.size = kNarrow, .pixels = std::vector<std::uint8_t>(3UL * kNarrow.width * kNarrow.height, 0)};
  draw_annotations(image, {.size = kNarrow}, label_at({0, -0.01, -0.0173}), snapshot, from_the_front());
  constexpr int kBesideTheOrgan = 740, kPanels = 546, kCaptions = kPanels - 22 - 90;
  int above = 0, in_the_way = 0;
  for (int y = 0; y < kPanels; ++y) {
    for (int x = kBesideTheOrgan; x < kNarrow.width; ++x) {
      (y < kCaptions ? above : in_the_way) += image.pixels[3 * static_cast<std::size_t>(y * kNarrow.width + x)] > 0;
    }
  }
  EXPECT_GT(above, 500);
  EXPECT_EQ(in_the_way, 0);
}

TEST(AnnotationDrawing, WhatLiesUnderAnInsetHasNoLabel) {
  Snapshot snapshot = scene();
  snapshot.time = 1;
  const PictureBox over_the_middle{.left = 400, .top = 200, .size = {480, 320}};
  Image image = black();
  draw_annotations(image, {.size = kSize}, label_at({0, -0.02, 0}), snapshot, from_the_front(), over_the_middle);
  EXPECT_EQ(image.pixels, black().pixels);
}

TEST(AnnotationDrawing, ALabelWhoseLineWouldRunUnderAnInsetStandsOnTheOtherSide) {
  Snapshot snapshot = scene();
  snapshot.time = 1;
  const Double3 at{0.003, -0.019, 0.006};  // a little right of the middle, and above it
  const auto point =
      resolve_camera(from_the_front(), scene_extent(snapshot), kSize, 1).pixel({at[0], at[1], at[2]}, kSize);
  ASSERT_TRUE(point);
  AnnotationDefinition annotations = label_at(at);
  CameraDefinition camera = from_the_front();
  const auto lit_on_the_left = [&](const std::optional<PictureBox>& inset) {
    Image image = black();
    draw_annotations(image, {.size = kSize}, annotations, snapshot, camera, inset);
    int lit = 0;
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < (*point)[0] - 20; ++x) lit += level(image, x + 0.5, y + 0.5) > 100;
    }
    return lit;
  };
  const PictureBox beside{.left = 720, .top = 60, .size = {534, 400}};
  EXPECT_EQ(lit_on_the_left({}), 0);
  EXPECT_GT(lit_on_the_left(beside), 200);
  camera.follow = CameraFollow{.tool = "probe"};
  EXPECT_EQ(lit_on_the_left(beside), 0) << "where it goes is not known";
  camera.follow.reset();
  annotations.labels[0].side = LabelSide::kRight;
  EXPECT_EQ(lit_on_the_left(beside), 0) << "as it was told";
}

TEST(AnnotationDrawing, NothingToSayChangesNothing) {
  EXPECT_EQ(drawn({}, scene()).pixels, black().pixels);
}

TEST(AnnotationDrawing, APointGivenOffTheWallIsThatOfTheWallWhichIsNearest) {
  // Where it was given there would be no room beside it, and the label would stand above the organ.
  Snapshot snapshot = scene();
  snapshot.time = 1;
  EXPECT_EQ(drawn(label_at({0.05, 0, 0}), snapshot).pixels, drawn(label_at({0.02, 0, 0}), snapshot).pixels);
}

}  // namespace
}  // namespace thinwall
