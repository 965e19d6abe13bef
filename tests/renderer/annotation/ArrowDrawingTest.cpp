#include "renderer/annotation/AnnotationDrawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/camera/Camera.hpp"
#include "renderer/overlay/LegendPlate.hpp"
#include "tests/renderer/annotation/AnnotatedScenes.hpp"

namespace thinwall {
namespace {

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

}  // namespace
}  // namespace thinwall
