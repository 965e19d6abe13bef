#include "renderer/picture/Renderer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "renderer/camera/Camera.hpp"
#include "renderer/camera/SceneExtent.hpp"
#include "renderer/picture/FrameUniforms.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

using Pixel = std::array<int, 3>;

Pixel pixel_at(const Image& image, int x, int y) {
  const std::size_t first = 3 * (static_cast<std::size_t>(y) * image.size.width + x);
  return {image.pixels[first], image.pixels[first + 1], image.pixels[first + 2]};
}

void expect_near(const Pixel& pixel, const Pixel& expected, int tolerance, const std::string& where) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(pixel[i], expected[i], tolerance) << where << ", channel " << i;
}

/// What tone.glsl makes of a grey radiance, in 8-bit levels.
double displayed(double radiance) {
  const double x = std::max(0.72 * radiance - 0.004, 0.0);
  return 255 * x * (6.2 * x + 0.5) / (x * (6.2 * x + 1.7) + 0.06);
}

Image draw(const Snapshot& snapshot, const ViewDefinition& view, ImageSize size, Tier tier = Tier::kRecord) {
  return Renderer(DeviceChoice{}, size, tier).draw(snapshot, view);
}

/// Seen from +x with a right angle of view: y to the right, z up; at the origin half the height shows 1 m.
CameraDefinition from_the_right() {
  return {.position = Double3{1, 0, 0},
          .target = Double3{0, 0, 0},
          .up = Double3{0, 0, 1},
          .field_of_view = std::numbers::pi / 2};
}

/// The same light from everywhere, no floor, black behind.
ViewDefinition furnace() {
  ViewDefinition view;
  view.camera = from_the_right();
  view.lights = {.key = 0, .fill = 0, .environment = 1, .environment_contrast = 0, .key_direction = {}};
  view.look.background = {0, 0, 0};
  view.look.floor = false;
  return view;
}

TissueLook plain(Double3 color) {
  return {.color = color, .roughness = 1, .wetness = 0, .mottling = 0};
}

Snapshot snapshot_of(std::vector<SnapshotSurface> surfaces) {
  Snapshot snapshot;
  snapshot.surfaces = std::move(surfaces);
  return snapshot;
}

Snapshot organ_and_probe() {
  Snapshot snapshot = snapshot_of({test::sphere("organ", {0, 0, 0.03}, 0.03, 4)});
  SnapshotTool probe;
  probe.tip = {0, 0, 0.06};
  snapshot.tools.push_back(probe);
  return snapshot;
}

TEST(Renderer, AnEmptySnapshotIsTheBackground) {
  ViewDefinition view;
  view.look.background = {0.2, 0.4, 0.6};
  for (const Tier tier : {Tier::kDraft, Tier::kRecord, Tier::kFinal}) {
    const Image image = draw({}, view, {64, 48}, tier);
    ASSERT_EQ(image.pixels.size(), 64u * 48 * 3);
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) expect_near(pixel_at(image, x, y), {51, 102, 153}, 1, "dithered by half a level");
    }
  }
}

TEST(Renderer, AWhiteBodyInAFurnaceIsAsBrightAsTheFurnace) {
  // Whatever white reflects diffusely, as gloss or from its wet layer, is the same light: nothing is lost or gained.
  for (const double wetness : {0.0, 1.0}) {
    for (const double roughness : {0.1, 1.0}) {
      ViewDefinition view = furnace();
      view.look.bodies["organ"] = {.color = {1, 1, 1}, .roughness = roughness, .wetness = wetness, .mottling = 0};
      const Image image = draw(snapshot_of({test::sphere("organ", {}, 0.4, 4)}), view, {100, 100});
      const int level = static_cast<int>(std::lround(displayed(1)));
      for (const auto& [x, y] : {std::pair{50, 50}, {50, 35}, {35, 50}, {65, 58}, {50, 66}}) {
        expect_near(pixel_at(image, x, y), {level, level, level}, 1, "white in a furnace");
      }
    }
  }
}

TEST(Renderer, ADarkerBodyInAFurnaceIsDarker) {
  ViewDefinition view = furnace();
  view.look.bodies["organ"] = plain({0.5, 0.5, 0.5});
  const Image image = draw(snapshot_of({test::sphere("organ", {}, 0.4, 4)}), view, {100, 100});
  // sRGB 0.5 reflects 21.4 %, and gloss of 3.5 % at normal incidence, some weaker for a rough surface, comes on top.
  const int level = pixel_at(image, 50, 50)[0];
  EXPECT_GE(level, displayed(0.214));
  EXPECT_LE(level, displayed(0.214 + 0.05));
}

SnapshotSurface wall_at(const std::string& body, float x, float half) {
  return test::quad(body, {{{x, -half, -half}, {x, half, -half}, {x, half, half}, {x, -half, half}}});
}

TEST(Renderer, TheNearerBodyHidesTheFartherWhateverTheOrder) {
  ViewDefinition view = furnace();
  view.look.bodies["near"] = plain({1, 0, 0});
  view.look.bodies["far"] = plain({0, 1, 0});
  const auto near = wall_at("near", 0.1f, 0.2f), far = wall_at("far", -0.1f, 0.6f);
  for (const Tier tier : {Tier::kDraft, Tier::kRecord}) {
    const Image one = draw(snapshot_of({near, far}), view, {101, 101}, tier);
    const Image other = draw(snapshot_of({far, near}), view, {101, 101}, tier);
    for (const Image& image : {one, other}) {
      EXPECT_GT(pixel_at(image, 50, 50)[0], 2 * pixel_at(image, 50, 50)[1]) << "near and red in the middle";
      EXPECT_GT(pixel_at(image, 50, 30)[1], 2 * pixel_at(image, 50, 30)[0]) << "far and green around";
    }
    EXPECT_EQ(one.pixels, other.pixels);
  }
}

TEST(Renderer, ATriangleLandsWhereTheCameraProjectsItWithTheFirstRowOnTop) {
  ViewDefinition view = furnace();
  view.look.bodies["organ"] = plain({1, 1, 1});
  // Around y = 0.5, z = 0.6: right of and above the middle.
  const auto triangle =
      test::surface_of("organ", {{0, 0.45f, 0.56f}, {0, 0.55f, 0.56f}, {0, 0.5f, 0.68f}}, {{0, 1, 2}});
  const Image image = draw(snapshot_of({triangle}), view, {200, 100});
  double x_sum = 0, y_sum = 0, weight = 0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 200; ++x) {
      const double light = pixel_at(image, x, y)[0];
      if (light <= 1) continue;
      x_sum += light * (x + 0.5);
      y_sum += light * (y + 0.5);
      weight += light;
    }
  }
  ASSERT_GT(weight, 0);
  // The centroid; smoothed edges leave some hundredths of a pixel.
  EXPECT_NEAR(x_sum / weight, 100 + 50 * 0.5, 0.1);
  EXPECT_NEAR(y_sum / weight, 50 - 50 * 0.6, 0.1);
}

/// A square turned by a little, so that its edges cross the raster at a slant. Seen from the right it is the same
/// however far away.
SnapshotSurface slanting_square(const std::string& body, float distance) {
  const float c = 0.5f * distance * std::cos(0.2f), s = 0.5f * distance * std::sin(0.2f), x = 1 - distance;
  return test::quad(body, {{{x, -c + s, -c - s}, {x, c + s, -c + s}, {x, c - s, c + s}, {x, -c - s, c - s}}});
}

TEST(Renderer, EdgesAreSmoothAndCoverTheRightAreaExceptInDraft) {
  ViewDefinition view = furnace();
  view.look.bodies["organ"] = plain({1, 1, 1});
  const double full = displayed(1);
  const auto measure = [&](Tier tier) {
    const Image image = draw(snapshot_of({slanting_square("organ", 1)}), view, {200, 200}, tier);
    int between = 0;
    double area = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
      between += image.pixels[i] > 2 && image.pixels[i] < full - 2;
      area += image.pixels[i] / full;
    }
    return std::pair{between, area};
  };
  EXPECT_EQ(measure(Tier::kDraft).first, 0);
  const auto [between, area] = measure(Tier::kRecord);
  // The outline of 400 pixels passes through as many columns or rows; those it crosses near their middle stay whole.
  EXPECT_GT(between, 300);
  // 100 x 100 pixels; dithering and the four corners leave a few.
  EXPECT_NEAR(area, 10000, 15);
  EXPECT_GT(measure(Tier::kFinal).first, 300);
}

void expect_smooth_columns(const std::vector<SnapshotSurface>& squares) {
  ViewDefinition view = furnace();
  for (const SnapshotSurface& square : squares) view.look.bodies[square.body] = plain({1, 1, 1});
  const Image image = draw(snapshot_of(squares), view, {200, 200});
  // Where a column meets the two long sides only, it cuts 100 / cos(0.2) pixels out of the square.
  for (int x = 70; x < 130; ++x) {
    double sum = 0;
    for (int y = 0; y < 200; ++y) sum += pixel_at(image, x, y)[0] / displayed(1);
    // Rounding a hundred pixels to 8 bits with dithering, and two of them in between, leaves 0.02.
    EXPECT_NEAR(sum, 100 / std::cos(0.2), 0.03) << "column " << x;
  }
}

TEST(Renderer, ASmoothEdgeLiesWhereTheGeometryPutsItInEachColumn) {
  expect_smooth_columns({slanting_square("organ", 1)});
}

TEST(Renderer, EdgesBehindEachOtherAreAsSmoothAsOne) {
  expect_smooth_columns({slanting_square("organ", 1), slanting_square("second", 1.1f), slanting_square("third", 1.2f)});
}

class ToolTip : public testing::TestWithParam<SnapshotToolKind> {};

TEST_P(ToolTip, IsSeenWhereItProjectsTo) {
  Snapshot snapshot;
  SnapshotTool tool;
  tool.kind = GetParam();
  tool.tip = {0, 0.02, -0.03};
  tool.radius = 0.01;
  tool.length = 0.04;
  snapshot.tools.push_back(tool);
  ViewDefinition view = furnace();
  view.camera.position = Double3{0.2, 0, 0};  // half the height shows 0.2 m
  const Image image = draw(snapshot, view, {401, 401});
  int lowest = -1, left = 401, right = -1;
  for (int y = 0; y < 401; ++y) {
    for (int x = 0; x < 401; ++x) {
      if (pixel_at(image, x, y)[1] < 20) continue;
      if (y > lowest) left = 401, right = -1;
      lowest = y;
      left = std::min(left, x);
      right = std::max(right, x);
    }
  }
  // The tip projects to (220.55, 230.58), a millimetre is a pixel; the last pixel row may be covered by
  // less than a tenth. The camera sees the nearer half of round tips some lower.
  EXPECT_NEAR(lowest, 230, 1.5);
  EXPECT_NEAR(0.5 * (left + right + 1), 220.55, 1.5);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ToolTip,
                         testing::Values(SnapshotToolKind::kPoint, SnapshotToolKind::kLine, SnapshotToolKind::kSphere));

/// The pixel that shows the floor's point in the middle of the organ's shadow.
std::array<int, 2> shadow_pixel(const Snapshot& snapshot, const ViewDefinition& view, ImageSize size) {
  const SceneExtent extent = scene_extent(snapshot);
  const Camera camera = resolve_camera(view.camera, extent, size, 0);
  const Vector3 key = arrange_studio(view.lights, camera).key_direction;
  const double height = extent.center.z - extent.floor_height;
  const auto pixel = camera.pixel(extent.center - (height / key.z) * key, size);
  return {static_cast<int>((*pixel)[0]), static_cast<int>((*pixel)[1])};
}

TEST(Renderer, TheKeyLightCastsAShadowExceptInDraft) {
  const Snapshot snapshot = organ_and_probe();
  ViewDefinition view;
  view.lights.key_direction = Double3{-1, 0, 0.6};  // low, so that the shadow leaves the organ's foot
  const ImageSize size{320, 180};
  const auto [x, y] = shadow_pixel(snapshot, view, size);
  ASSERT_TRUE(x > 0 && x < size.width && y > 0 && y < size.height);
  const Image draft = draw(snapshot, view, size, Tier::kDraft);
  const Image record = draw(snapshot, view, size, Tier::kRecord);
  const Image final_image = draw(snapshot, view, size, Tier::kFinal);
  const int lit = pixel_at(draft, x, y)[2];
  EXPECT_LT(pixel_at(record, x, y)[2], 0.6 * lit);
  EXPECT_NEAR(pixel_at(final_image, x, y)[2], pixel_at(record, x, y)[2], 2);
  // The lower left corner is on the light's side.
  EXPECT_EQ(pixel_at(record, 3, size.height - 3), pixel_at(draft, 3, size.height - 3));
}

/// The part of the pixels of `image` that are darker or brighter than all of `coarse` around them, by more than
/// `levels`.
double part_beyond_neighbours(const Image& image, const Image& coarse, int levels) {
  int beyond = 0;
  for (int y = 1; y + 1 < image.size.height; ++y) {
    for (int x = 1; x + 1 < image.size.width; ++x) {
      int least = 255, most = 0;
      for (int k = 0; k < 9; ++k) {
        const int level = pixel_at(coarse, x + k % 3 - 1, y + k / 3 - 1)[0];
        least = std::min(least, level);
        most = std::max(most, level);
      }
      const int level = pixel_at(image, x, y)[0];
      beyond += level < least - levels || level > most + levels;
    }
  }
  return static_cast<double>(beyond) / (image.size.width * image.size.height);
}

TEST(Renderer, FinalShowsBetweenNeighboursWhatRecordShowsThere) {
  const Snapshot snapshot = organ_and_probe();
  const ImageSize size{320, 180};
  const Image record = draw(snapshot, {}, size, Tier::kRecord);
  const Image final_image = draw(snapshot, {}, size, Tier::kFinal);
  EXPECT_NE(record.pixels, final_image.pixels);
  // A finer map of shadows and glints in the corners alone lie beyond: 0.0002 of the pixels.
  EXPECT_LT(part_beyond_neighbours(final_image, record, 4), 0.001);
}

TEST(Renderer, AToolShadesTheTissueBelowIt) {
  Snapshot snapshot = organ_and_probe();
  const ViewDefinition view;
  const ImageSize size{320, 180};
  const Image with = draw(snapshot, view, size);
  snapshot.tools.clear();
  const Image without = draw(snapshot, view, size);
  const SceneExtent extent = scene_extent(snapshot);
  const Camera camera = resolve_camera(view.camera, extent, size, 0);
  const Vector3 key = arrange_studio(view.lights, camera).key_direction;
  // Where the shadow of the shaft, 5 mm above the tip, meets the top of the sphere of 30 mm around (0, 0, 0.03).
  const Vector3 shaft = Vector3{0, 0, 0.065} - extent.center;
  const double along = dot(shaft, key) - std::sqrt(dot(shaft, key) * dot(shaft, key) - dot(shaft, shaft) + 0.0009);
  const auto pixel = camera.pixel(extent.center + shaft - along * key, size);
  ASSERT_TRUE(pixel);
  const int x = static_cast<int>((*pixel)[0]), y = static_cast<int>((*pixel)[1]);
  EXPECT_LT(pixel_at(with, x, y)[0], 0.9 * pixel_at(without, x, y)[0]);
}

/// A near view takes a finer map of shadows.
TEST(Renderer, APictureIsTheSameAfterNearOnesAndAfterFarOnes) {
  const Snapshot snapshot = organ_and_probe();
  ViewDefinition near;
  near.camera.position = Double3{-0.006, -0.008, 0.078};
  near.camera.target = Double3{0.004, 0.002, 0.06};
  const ImageSize size{1280, 720};
  const SceneExtent extent = scene_extent(snapshot);
  const auto resolution = [&](const ViewDefinition& view) {
    const Camera camera = resolve_camera(view.camera, extent, size, 0);
    const Matrix4 matrix = key_light_matrix(extent, arrange_studio(view.lights, camera), camera);
    return shadow_resolution(Tier::kRecord, shadow_map_pixels(matrix, extent, camera, size), false);
  };
  ASSERT_NE(resolution(near), resolution({}));
  const Image near_alone = draw(snapshot, near, size), far_alone = draw(snapshot, {}, size);
  Renderer renderer(DeviceChoice{}, size, Tier::kRecord);
  for (int turn = 0; turn < 2; ++turn) {
    EXPECT_EQ(renderer.draw(snapshot, near).pixels, near_alone.pixels);
    EXPECT_EQ(renderer.draw(snapshot, {}).pixels, far_alone.pixels);
  }
}

TEST(Renderer, TheCameraOfATakeStaysWhenTheTissueMoves) {
  Snapshot snapshot = organ_and_probe();
  const ViewDefinition view;
  const Image before = draw(snapshot, view, {160, 90});
  snapshot.surfaces[0].positions[4][2] -= 0.004f;
  const Image after = draw(snapshot, view, {160, 90});
  EXPECT_NE(before.pixels, after.pixels);
  // The left quarter shows floor and the organ's side, far from the dent.
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 40; ++x) EXPECT_EQ(pixel_at(before, x, y), pixel_at(after, x, y));
  }
}

}  // namespace
}  // namespace thinwall
