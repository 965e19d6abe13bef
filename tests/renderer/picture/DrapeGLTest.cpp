#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/camera/Camera.hpp"
#include "renderer/camera/SceneExtent.hpp"
#include "renderer/look/OrganLooks.hpp"
#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kDrapeSize{320, 180};

/// Of 60 mm, 2 mm thick, seen from the front; the middle of its 3 by 3 vertices lies `pressed` metres lower.
Snapshot skin_sheet(float pressed = 0) {
  std::vector<Float3> places;
  for (const float y : {-0.03F, 0.0F, 0.03F}) {
    for (const float x : {-0.03F, 0.0F, 0.03F}) places.push_back({x, y, 0});
  }
  SnapshotSurface surface = test::surface_of(
      "skin", places, {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {3, 4, 7}, {3, 7, 6}, {4, 5, 8}, {4, 8, 7}});
  auto topology = std::make_shared<SnapshotTopology>(*surface.topology);
  topology->thickness.assign(8, 0.002F);
  surface.topology = topology;
  surface.positions[4][2] = -pressed;
  Snapshot snapshot;
  snapshot.surfaces = {surface};
  return snapshot;
}

Snapshot ball() {
  Snapshot snapshot;
  snapshot.surfaces = {test::sphere("organ", {0, 0, 0.03}, 0.03, 3)};
  return snapshot;
}

ViewDefinition seen_from(Double3 position) {
  ViewDefinition view;
  view.camera = {.position = position, .target = Double3{0, 0, 0}};
  view.look.bodies["skin"] = *find_organ_look("skin");
  return view;
}

ViewDefinition with_ground(ViewDefinition view, Ground ground) {
  view.look.ground = ground;
  return view;
}

Image draw(const Snapshot& snapshot, const ViewDefinition& view, Tier tier = Tier::kRecord) {
  return Renderer(DeviceChoice{}, kDrapeSize, tier).draw(snapshot, view);
}

std::array<double, 3> mean_color(const Image& image, int left, int top, int width, int height) {
  std::array<double, 3> sums{};
  for (int y = top; y < top + height; ++y) {
    for (int x = left; x < left + width; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        sums[c] += image.pixels[3 * (static_cast<std::size_t>(y) * kDrapeSize.width + x) + c] / (1.0 * width * height);
      }
    }
  }
  return sums;
}

const Double3 kFront{0.04, -0.16, 0.13};

TEST(Drape, LiesBelowSheetsAndTheFloorBelowClosedBodies) {
  const ViewDefinition view = seen_from(kFront);
  EXPECT_EQ(draw(skin_sheet(), view).pixels, draw(skin_sheet(), with_ground(view, Ground::kDrape)).pixels);
  EXPECT_EQ(draw(ball(), view).pixels, draw(ball(), with_ground(view, Ground::kFloor)).pixels);
  EXPECT_NE(draw(ball(), view).pixels, draw(ball(), with_ground(view, Ground::kDrape)).pixels);
}

TEST(Drape, IsNotBelowNumbersAndMeshes) {
  ViewDefinition view = seen_from(kFront);
  view.look.mesh = true;
  EXPECT_EQ(draw(skin_sheet(), view).pixels, draw(skin_sheet(), with_ground(view, Ground::kFloor)).pixels);
  view.look.mesh = false;
  view.look.data = DataView{.quantity = DataQuantity::kDisplacement, .from = 0, .to = 0.01};
  EXPECT_EQ(draw(skin_sheet(), view).pixels, draw(skin_sheet(), with_ground(view, Ground::kFloor)).pixels);
}

/// With y upwards, as many files have it: z comes towards the viewer.
Float3 with_y_upwards(const Float3& place) {
  return {place[0], place[2], -place[1]};
}
Double3 with_y_upwards(const Double3& place) {
  return {place[0], place[2], -place[1]};
}

TEST(Drape, LiesBelowWhatGravityPullsAtWhereverThatIs) {
  const ViewDefinition view = seen_from(kFront);
  Snapshot snapshot = skin_sheet();
  const Image lying = draw(snapshot, view);
  snapshot.gravity = {0, -5, -9};
  EXPECT_EQ(draw(snapshot, view).pixels, lying.pixels);
  auto topology = std::make_shared<SnapshotTopology>(*snapshot.surfaces[0].topology);
  for (Float3& place : topology->rest_positions) place = with_y_upwards(place);
  for (Float3& place : snapshot.surfaces[0].positions) place = with_y_upwards(place);
  snapshot.surfaces[0].topology = topology;
  snapshot.gravity = {0, -9.81, 0};
  ViewDefinition turned_view = seen_from(with_y_upwards(kFront));
  turned_view.camera.up = Double3{0, 1, 0};
  const Image standing = draw(snapshot, turned_view);
  int largest = 0;
  for (std::size_t k = 0; k < lying.pixels.size(); ++k) {
    largest = std::max(largest, std::abs(int{lying.pixels[k]} - int{standing.pixels[k]}));
  }
  // The camera is the same but for roundings: none was seen.
  EXPECT_LE(largest, 1);
}

TEST(Drape, IsGreenBlueClothAroundTheSheet) {
  const Image image = draw(skin_sheet(), seen_from(kFront));
  for (const int left : {0, kDrapeSize.width - 24}) {
    const auto [red, green, blue] = mean_color(image, left, kDrapeSize.height - 24, 24, 24);
    EXPECT_GT(green, red + 25);
    EXPECT_GT(blue, red + 25);
    EXPECT_GT(green, 60);
    EXPECT_LT(green, 170);
  }
}

TEST(Drape, StaysWhereItIsWhenTheSheetIsPressedDown) {
  const ViewDefinition view = seen_from(kFront);
  const Image before = draw(skin_sheet(), view), after = draw(skin_sheet(0.006F), view);
  EXPECT_NE(before.pixels, after.pixels);
  for (std::size_t i = 0; i < 3U * 40U * kDrapeSize.width; ++i) ASSERT_EQ(before.pixels[i], after.pixels[i]) << i;
}

TEST(Drape, IsShadedWhereTheSheetTouchesIt) {
  ViewDefinition view = seen_from({0, -0.001, 0.3});
  view.camera.up = Double3{0, 1, 0};
  view.lights.key_direction = Double3{0, 0, 1};
  // 60 mm are 67 of 180 pixels: beside the sheet's right side, and far from it; drafts have no shade.
  const Image shaded = draw(skin_sheet(), view), draft = draw(skin_sheet(), view, Tier::kDraft);
  EXPECT_LT(mean_color(shaded, 195, 80, 2, 20)[1], 0.8 * mean_color(draft, 195, 80, 2, 20)[1]);
  EXPECT_NEAR(mean_color(shaded, 250, 80, 2, 20)[1], mean_color(draft, 250, 80, 2, 20)[1], 2);
}

/// How much neighbours of a row differ, on the mean, at the lower border.
double roughness_of(const Image& image) {
  double sum = 0;
  int count = 0;
  for (int y = kDrapeSize.height - 16; y < kDrapeSize.height; ++y) {
    for (int x = 0; x + 1 < 60; ++x) {
      const std::size_t first = 3 * (static_cast<std::size_t>(y) * kDrapeSize.width + x) + 1;
      sum += std::abs(image.pixels[first + 3] - image.pixels[first]);
      ++count;
    }
  }
  return sum / count;
}

TEST(Drape, ShowsItsThreadsFromNearByAndDoesNotSparkleFromAfar) {
  EXPECT_GT(roughness_of(draw(skin_sheet(), seen_from({0.015, -0.06, 0.05}))), 1.5);
  EXPECT_LT(roughness_of(draw(skin_sheet(), seen_from({0.10, -0.40, 0.32}))), 0.8);
}

TEST(Drape, IsSeenBelowTheRimOfACutSheetAndNotTheBedOfItsWound) {
  Snapshot cut, whole;
  cut.surfaces = {test::slit_sheet(20, 0.001, 0)};
  whole.surfaces = {test::slit_sheet(20, 0.001, 0, 10)};
  for (const double height : {0.008, 0.03, -0.02}) {
    SCOPED_TRACE(height);
    ViewDefinition view = seen_from({0, -0.05, height});
    view.look.bodies["organ"] = *find_organ_look("skin");
    // Drafts have no shadows, which the bed casts too.
    const Image with = draw(cut, view, Tier::kDraft), without = draw(whole, view, Tier::kDraft);
    // The sheet ends 10 mm before its middle.
    const auto rim = resolve_camera(view.camera, scene_extent(cut), kDrapeSize, 0).pixel({0, -0.01, 0}, kDrapeSize);
    ASSERT_TRUE(rim);
    const auto first = 3 * static_cast<std::ptrdiff_t>((*rim)[1]) * kDrapeSize.width;
    EXPECT_TRUE(std::equal(with.pixels.begin() + first, with.pixels.end(), without.pixels.begin() + first));
  }
}

TEST(Drape, TakesUpWhatRunsOffTheSheet) {
  Snapshot snapshot;
  snapshot.surfaces = {test::slit_sheet(20, 0.001, 0.8)};
  snapshot.time = 3;
  ViewDefinition view = seen_from({0, -0.12, 0});
  view.camera.target = Double3{0, 0, -0.02};
  view.look.bodies["organ"] = *find_organ_look("vessel");
  view.look.bodies["organ"].bleeding = 0;
  const Image dry = draw(snapshot, view);
  snapshot.scalars = {{"organ.leaked", "m^3", 1e-5}};
  const Image wet = draw(snapshot, view);
  // The sheet ends 9 mm below its middle, 7 mm before it; a drop there is 2.6 mm high.
  const SceneExtent extent = scene_extent(snapshot);
  const auto lowest = resolve_camera(view.camera, extent, kDrapeSize, 0).pixel({0, -0.0085, -0.0095}, kDrapeSize);
  ASSERT_TRUE(lowest);
  int changed = 0;
  for (std::size_t i = 0; i < dry.pixels.size(); ++i) {
    if (dry.pixels[i] == wet.pixels[i]) continue;
    ++changed;
    EXPECT_LE(static_cast<double>(i / (3U * kDrapeSize.width)), (*lowest)[1]);
  }
  EXPECT_GT(changed, 30);
}

TEST(Drape, HasItsThreadsOnceInTheFinalTier) {
  const ViewDefinition view = seen_from({0.015, -0.06, 0.05});
  const Image record = draw(skin_sheet(), view), final_image = draw(skin_sheet(), view, Tier::kFinal);
  // Corners of pixels that are averaged take some away; threads on threads would add.
  EXPECT_GT(roughness_of(final_image), 0.6 * roughness_of(record));
  EXPECT_LT(roughness_of(final_image), roughness_of(record));
}

}  // namespace
}  // namespace thinwall
