#include "renderer/annotation/AnnotationDrawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/annotation/Card.hpp"
#include "renderer/camera/Camera.hpp"
#include "renderer/overlay/LegendPlate.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize{1280, 720};

Snapshot scene(double stretch = 1) {
  Snapshot snapshot;
  snapshot.surfaces.push_back(test::sphere("organ", {0, 0, 0}, 0.02, 3));
  for (Float3& position : snapshot.surfaces[0].positions) position[0] *= static_cast<float>(stretch);
  SnapshotTool& tool = snapshot.tools.emplace_back();
  tool.name = "probe";
  tool.tip = {0, 0, 0.02};
  tool.force = {0, 0, 0.5};
  return snapshot;
}

CameraDefinition from_the_front() {
  CameraDefinition camera;
  camera.position = Double3{0, -0.12, 0};
  camera.target = Double3{0, 0, 0};
  return camera;
}

Image black() {
  return {.size = kSize, .pixels = std::vector<std::uint8_t>(3UL * kSize.width * kSize.height, 0)};
}

int level(const Image& image, double x, double y) {
  const auto pixel = static_cast<std::size_t>(std::lround(y - 0.5)) * static_cast<std::size_t>(kSize.width) +
                     static_cast<std::size_t>(std::lround(x - 0.5));
  return image.pixels[3 * pixel];
}

Image drawn(const AnnotationDefinition& annotations, const Snapshot& snapshot) {
  Image image = black();
  draw_annotations(image, {.size = kSize}, annotations, snapshot, from_the_front());
  return image;
}

AnnotationDefinition label_at(Double3 at) {
  AnnotationDefinition annotations;
  annotations.labels.push_back({.text = "Fundus", .body = "organ", .at = at, .span = {.begin = 0.5, .end = 2}});
  return annotations;
}

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

TEST(AnnotationDrawing, AForceArrowEndsWhereItsLengthSays) {
  const Snapshot snapshot = scene();
  AnnotationDefinition annotations;
  annotations.force_arrows.push_back({.tool = "probe", .full = 1, .length = 0.02});
  const Image image = drawn(annotations, snapshot);
  const Camera camera = resolve_camera(from_the_front(), scene_extent(snapshot), kSize, 0);
  // Half of the full force: half of the length.
  const auto tip = camera.pixel({0, 0, 0.03}, kSize);
  ASSERT_TRUE(tip);
  EXPECT_GT(level(image, (*tip)[0], (*tip)[1] + 6), 200) << "inside the head";
  EXPECT_LT(level(image, (*tip)[0], (*tip)[1] - 6), 60) << "beyond the tip";
}

TEST(AnnotationDrawing, AForceAlongTheLineOfSightIsARingWithWords) {
  Snapshot snapshot = scene();
  AnnotationDefinition annotations;
  annotations.force_arrows.push_back({.tool = "probe", .full = 1, .length = 0.02});
  const Camera camera = resolve_camera(from_the_front(), scene_extent(snapshot), kSize, 0);
  const auto tail = camera.pixel({0, 0, 0.02}, kSize);
  ASSERT_TRUE(tail);
  const auto lit_beside = [&](const Image& image) {
    int lit = 0;
    for (int x = 20; x < 150; ++x) {
      for (int y = -20; y < 20; ++y) lit += level(image, (*tail)[0] + x, (*tail)[1] + y) > 200;
    }
    return lit;
  };
  // From the tool's tip to the eye, and away from it.
  for (const double sense : {1.0, -1.0}) {
    snapshot.tools[0].force = {0, -0.12 * 4 * sense, -0.02 * 4 * sense};
    const Image image = drawn(annotations, snapshot);
    EXPECT_GT(level(image, (*tail)[0], (*tail)[1]), 200);
    EXPECT_EQ(level(image, (*tail)[0] + 4, (*tail)[1]) > 200, false) << "between the ring and what is in its middle";
    EXPECT_EQ(level(image, (*tail)[0] + 3.5, (*tail)[1] + 3.5) > 200, sense < 0) << "a cross goes away";
    EXPECT_GT(lit_beside(image), 30) << "its words";
  }
  snapshot.tools[0].force = {0, -0.012, -0.002};
  EXPECT_EQ(drawn(annotations, snapshot).pixels, black().pixels) << "one that is short from the side too";
}

TEST(AnnotationDrawing, AForcesWordsStandBesideItsOwnToolWhateverElseIsThere) {
  Snapshot snapshot = scene();
  snapshot.tools[0].kind = SnapshotToolKind::kSphere;
  snapshot.tools[0].radius = 0.003;
  AnnotationDefinition annotations;
  annotations.force_arrows.push_back({.tool = "probe", .full = 1, .length = 0.02});
  const Image alone = drawn(annotations, snapshot);
  // A rod farther to the right, at the same height: words beyond it would be read as its force.
  SnapshotTool& other = snapshot.tools.emplace_back(snapshot.tools[0]);
  other.name = "rod";
  other.tip = {0.03, 0, 0.02};
  EXPECT_EQ(drawn(annotations, snapshot).pixels, alone.pixels);
}

TEST(AnnotationDrawing, AnArrowsWordsStandBesideTheTool) {
  Snapshot snapshot = scene();
  snapshot.tools[0].kind = SnapshotToolKind::kSphere;
  snapshot.tools[0].radius = 0.004;
  AnnotationDefinition silent;
  silent.arrows.push_back({.text = "", .body = "organ", .at = {0, 0, 0.02}, .length = 0.012});
  AnnotationDefinition speaking = silent;
  speaking.arrows[0].text = "Press here";
  const Image without = drawn(silent, snapshot), with = drawn(speaking, snapshot);
  const Camera camera = resolve_camera(from_the_front(), scene_extent(snapshot), kSize, 0);
  const double edge = (*camera.pixel({0.0042, 0, 0.024}, kSize))[0], shaft = (*camera.pixel({0, 0, 0.024}, kSize))[0];
  EXPECT_NE(with.pixels, without.pixels);
  for (int y = 0; y < kSize.height; ++y) {
    for (double x = shaft - (edge - shaft); x < edge; x += 1) {
      EXPECT_EQ(level(with, x, y + 0.5), level(without, x, y + 0.5)) << x << ' ' << y;
    }
  }
}

TEST(AnnotationDrawing, WordsOfAnArrowThatGoesSidewaysStandBeyondItsTail) {
  const Snapshot snapshot = scene();
  const Camera camera = resolve_camera(from_the_front(), scene_extent(snapshot), kSize, 0);
  for (const double sense : {1.0, -1.0}) {
    AnnotationDefinition annotations;
    annotations.arrows.push_back(
        {.text = "Pulled", .body = "organ", .at = {0, -0.02, 0}, .direction = {sense, 0, 0}, .length = 0.02});
    const Image image = drawn(annotations, snapshot);
    const auto tail = camera.pixel({-0.02 * sense, -0.02, 0}, kSize);
    ASSERT_TRUE(tail);
    int beyond = 0;
    for (int x = 10; x < 90; ++x) {
      for (int y = -12; y < 12; ++y) beyond += level(image, (*tail)[0] - sense * x, (*tail)[1] + y) > 200;
    }
    EXPECT_GT(beyond, 30) << sense;
  }
}

TEST(AnnotationDrawing, WordsOfAnArrowLeaveAWoundFree) {
  Snapshot snapshot = scene();
  snapshot.tools.clear();
  SnapshotSurface& surface = snapshot.surfaces[0];
  SnapshotTopology topology = *surface.topology;
  topology.cut_times.assign(surface.positions.size(), kNeverCut);
  const Camera camera = resolve_camera(from_the_front(), scene_extent(snapshot), kSize, 0);
  double left = kSize.width, right = 0, top = kSize.height, bottom = 0;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const auto [x, y, z] = surface.positions[v];
    if (x < -0.010F || x > -0.002F || y > -0.01F || std::abs(z) > 0.002F) continue;
    topology.cut_times[v] = 0;
    const auto at = camera.pixel({x, y, z}, kSize);
    left = std::min(left, (*at)[0]), right = std::max(right, (*at)[0]);
    top = std::min(top, (*at)[1]), bottom = std::max(bottom, (*at)[1]);
  }
  ASSERT_LT(left, right);
  AnnotationDefinition silent;
  silent.arrows.push_back(
      {.text = "", .body = "organ", .at = {0.01, -0.017, 0}, .direction = {1, 0, 0}, .length = 0.01});
  AnnotationDefinition speaking = silent;
  speaking.arrows[0].text = "Tension lines";
  const auto levels_in_wound = [&](const Image& image) {
    std::vector<int> levels;
    for (double y = top; y <= bottom; ++y) {
      for (double x = left; x <= right; ++x) levels.push_back(level(image, x, y));
    }
    return levels;
  };
  EXPECT_NE(levels_in_wound(drawn(speaking, snapshot)), levels_in_wound(drawn(silent, snapshot))) << "without a wound";
  surface.topology = std::make_shared<const SnapshotTopology>(topology);
  EXPECT_EQ(levels_in_wound(drawn(speaking, snapshot)), levels_in_wound(drawn(silent, snapshot)));
  EXPECT_NE(drawn(speaking, snapshot).pixels, drawn(silent, snapshot).pixels);
}

TEST(AnnotationDrawing, AnArrowPassesBelowLabels) {
  Snapshot snapshot = scene();
  snapshot.time = 1;
  const AnnotationDefinition label = label_at({0.02, 0, 0});
  AnnotationDefinition both = label;
  both.arrows.push_back({.text = "", .body = "organ", .at = {0.02, 0, 0}, .direction = {-1, 0, 0}, .length = 0.06});
  const Image alone = drawn(label, snapshot), crossed = drawn(both, snapshot);
  EXPECT_NE(crossed.pixels, alone.pixels);
  int struck_out = 0;
  for (std::size_t k = 0; k < alone.pixels.size(); k += 3)
    struck_out += alone.pixels[k] > 220 && crossed.pixels[k] < 200;
  EXPECT_EQ(struck_out, 0) << "letters, the leader and its dot";
}

TEST(AnnotationDrawing, TextsOfArrowsAtOnePlaceKeepClearOfEachOther) {
  Snapshot snapshot = scene();
  snapshot.time = 1;
  const auto inked = [&](const std::vector<std::string>& texts) {
    AnnotationDefinition annotations;
    for (const std::string& text : texts) {
      annotations.arrows.push_back({.text = text, .body = "organ", .at = {0.02, 0, 0}, .length = 0.012});
    }
    const Image image = drawn(annotations, snapshot);
    return image.pixels.size() - static_cast<std::size_t>(std::ranges::count(image.pixels, 0));
  };
  const std::size_t arrow = inked({""}), one = inked({"Press here"}) - arrow;
  EXPECT_GT(one, 1000);
  // Rims of plates may lie between pixels.
  const std::size_t three = inked({"Press here", "Press here", "Press here"}) - arrow;
  EXPECT_NEAR(static_cast<double>(three), 3.0 * static_cast<double>(one), 0.1 * static_cast<double>(one));
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

TEST(AnnotationDrawing, TextsOfArrowsLeaveThePointsOfLabelsFree) {
  Snapshot snapshot = scene();
  snapshot.time = 1;
  const Camera camera = resolve_camera(from_the_front(), scene_extent(snapshot), kSize, 1);
  const Double3 pointed_at = {0.0135, -0.0147, 0};
  AnnotationDefinition annotations = label_at(pointed_at);
  // Its text would stand right of its tail, over the point.
  annotations.arrows.push_back({.text = "Press", .body = "organ", .at = {0.01, -0.0173, 0}, .direction = {1, 0, 0}});
  annotations.arrows[0].length = 0.002;
  const Image image = drawn(annotations, snapshot);
  const auto point = camera.pixel({pointed_at[0], pointed_at[1], pointed_at[2]}, kSize);
  ASSERT_TRUE(point);
  EXPECT_GT(level(image, (*point)[0], (*point)[1]), 200) << "the dot is white";
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

TEST(AnnotationDrawing, NothingToSayChangesNothing) {
  EXPECT_EQ(drawn({}, scene()).pixels, black().pixels);
}

TEST(Card, DarkensThePictureAndFades) {
  Image bright{.size = kSize, .pixels = std::vector<std::uint8_t>(3UL * kSize.width * kSize.height, 200)};
  Image full = bright;
  draw_card(full, bright, {.title = "Title", .text = "and more"});
  // 84 % of a nearly black layer; its opacity, its colour and the sum are rounded to whole levels.
  EXPECT_NEAR(level(full, 10, 10), 0.16 * 200 + 0.84 * 0.02 * 255, 2);
  Image gone = bright;
  draw_card(gone, bright, {.title = "Title", .opacity = 0});
  EXPECT_EQ(gone.pixels, bright.pixels);
}

TEST(Card, TakesThePlaceOfWhatWasWrittenOnThePictureBefore) {
  const Image bare{.size = kSize, .pixels = std::vector<std::uint8_t>(3UL * kSize.width * kSize.height, 100)};
  Image written = bare;
  std::fill_n(written.pixels.begin(), 3 * 2 * kSize.width, std::uint8_t{220});
  for (const double opacity : {0.5, 1.0}) {
    Image over = written, empty = bare;
    draw_card(over, bare, {.title = "Title", .opacity = opacity});
    draw_card(empty, bare, {.title = "Title", .opacity = opacity});
    // Of the difference of 120 levels as much is left as the card lets through, and of that what has not gone.
    EXPECT_NEAR(level(over, 10, 1) - level(empty, 10, 1), 120 * (1 - opacity) * (1 - 0.84 * opacity), 2) << opacity;
    EXPECT_EQ(level(over, 10, 10), level(empty, 10, 10));
  }
}

}  // namespace
}  // namespace thinwall
