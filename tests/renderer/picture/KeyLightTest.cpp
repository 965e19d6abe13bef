#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/picture/FrameUniforms.hpp"

namespace thinwall {
namespace {

/// A sheet of 60 mm by 20 mm, at rest.
SceneExtent sheet() {
  SceneExtent extent;
  for (const double x : {-0.03, 0.0, 0.03}) {
    for (const double y : {-0.01, 0.0, 0.01}) extent.rest_points.push_back({x, y, 0});
  }
  extent.size = 2 * std::hypot(0.03, 0.01);
  extent.reach = 0.5 * extent.size;
  return extent;
}

/// Sees `half_width` (metres) to both sides of `middle`, from above.
Camera camera_above(Vector3 middle, double half_width) {
  Camera camera;
  camera.position = middle + Vector3{0, 0, 0.1};
  camera.right = {1, 0, 0};
  camera.up = {0, 1, 0};
  camera.forward = {0, 0, -1};
  camera.tangent_x = camera.tangent_y = half_width / 0.1;
  return camera;
}

const Camera kSeesAll = camera_above({}, 0.1);

/// Most of |x| and of |y| of all rest points in the map.
std::array<double, 2> most_in_map(const SceneExtent& extent, const Studio& studio, const Camera& camera = kSeesAll) {
  const Matrix4 matrix = key_light_matrix(extent, studio, camera);
  std::array<double, 2> most{};
  for (const Vector3& point : extent.rest_points) {
    std::array<double, 4> clip{};
    for (int row = 0; row < 4; ++row) {
      clip[static_cast<std::size_t>(row)] =
          matrix(row, 0) * point.x + matrix(row, 1) * point.y + matrix(row, 2) * point.z + matrix(row, 3);
    }
    for (std::size_t axis = 0; axis < 2; ++axis) most[axis] = std::max(most[axis], std::abs(clip[axis] / clip[3]));
  }
  return most;
}

Studio lamp_at(Vector3 place) {
  return {.key_direction = normalized(place),
          .fill_direction = normalized(place),
          .front = {0, -1, 0},
          .lamp_place = place};
}

const Studio kFarLamp = {.key_direction = {0.6, 0, 0.8}, .fill_direction = {0, 0, 1}, .front = {0, -1, 0}};

/// The margin around it is 15 %; beyond nine tenths shadows fade.
TEST(KeyLight, FillsItsMapWithTheTissueAtRest) {
  for (const Studio& studio : {kFarLamp, lamp_at({0.01, -0.03, 0.06})}) {
    for (const double most : most_in_map(sheet(), studio)) EXPECT_NEAR(most, 1 / 1.15, 1e-6);
  }
}

TEST(KeyLight, LeavesRoomForTissueThatHasGrown) {
  SceneExtent extent = sheet();
  extent.reach *= 1.25;
  for (const double most : most_in_map(extent, kFarLamp)) EXPECT_NEAR(most, 1 / (1.15 * 1.25), 1e-6);
}

/// A sheet of 60 mm by 60 mm whose points lie 1 mm apart.
SceneExtent fine_sheet() {
  SceneExtent extent;
  for (int i = -30; i <= 30; ++i) {
    for (int k = -30; k <= 30; ++k) extent.rest_points.push_back({1e-3 * i, 1e-3 * k, 0});
  }
  extent.size = 2 * std::hypot(0.03, 0.03);
  extent.reach = 0.5 * extent.size;
  return extent;
}

const Studio kLampAbove = {.key_direction = {0, 0, 1}, .fill_direction = {0, 0, 1}, .front = {0, -1, 0}};

TEST(KeyLight, FillsItsMapWithWhatThePictureShows) {
  const SceneExtent extent = fine_sheet();
  const Vector3 middle{0.012, -0.008, 0};
  constexpr double kHalf = 0.01;
  const Matrix4 matrix = key_light_matrix(extent, kLampAbove, camera_above(middle, kHalf));
  double most = 0, most_seen = 0;
  for (const Vector3& point : extent.rest_points) {
    const bool is_seen = std::max(std::abs(point.x - middle.x), std::abs(point.y - middle.y)) <= kHalf;
    for (int row = 0; row < 2; ++row) {
      const double place =
          matrix(row, 0) * point.x + matrix(row, 1) * point.y + matrix(row, 2) * point.z + matrix(row, 3);
      most = std::max(most, std::abs(place));
      if (is_seen) most_seen = std::max(most_seen, std::abs(place));
    }
  }
  EXPECT_LT(most_seen, 0.9) << "beyond nine tenths shadows fade";
  EXPECT_GT(most_seen, 0.6);
  EXPECT_GT(most, 1.5) << "the rest of the sheet is beside the map";
}

/// How many pixels of a picture of 200 by 200 the map's raster is wide, from near.
double pixels_from_near(const SceneExtent& extent, Vector3 middle, double half_width) {
  const Camera camera = camera_above(middle, half_width);
  return shadow_map_pixels(key_light_matrix(extent, kLampAbove, camera), extent, camera, {200, 200});
}

TEST(KeyLight, SeenFromNearFillsItsMapWithThePointsAroundThePicture) {
  const SceneExtent extent = fine_sheet();
  // A map of the whole sheet would be 4900 pixels wide.
  EXPECT_LT(pixels_from_near(extent, {}, 0.002), 2500);
  const double between_points = pixels_from_near(extent, {0.0105, 0.0105, 0}, 0.0004);
  EXPECT_GT(between_points, 1000) << "as the points beside the picture tell";
  EXPECT_LT(between_points, 13000) << "a map of the whole sheet would be 24400 pixels wide";
}

TEST(KeyLight, KeepsItsMapWhileTheCameraMovesALittle) {
  const SceneExtent extent = fine_sheet();
  const auto map_at = [&](double x) {
    return key_light_matrix(extent, kLampAbove, camera_above({x, 0, 0}, 0.01)).values;
  };
  EXPECT_EQ(map_at(0.0002), map_at(0.0004));
  EXPECT_NE(map_at(0), map_at(0.01));
}

TEST(KeyLight, OfFewPointsKeepsAllInItsMap) {
  const Camera beside = camera_above({0.02, 0, 0}, 0.012);
  for (const double most : most_in_map(sheet(), kFarLamp, beside)) EXPECT_NEAR(most, 1 / 1.15, 1e-6);
}

TEST(KeyLight, ItsMapIsAsManyPixelsWideAsItIsInThePicture) {
  const SceneExtent extent = fine_sheet();
  const auto pixels = [&](double half_width) {
    const Camera camera = camera_above({}, half_width);
    return shadow_map_pixels(key_light_matrix(extent, kLampAbove, camera), extent, camera, {200, 200});
  };
  // It lies at a slant: the diagonal of 60 mm by 60 mm, 15 % more, in pixels of 1 mm.
  EXPECT_NEAR(pixels(0.1), 1.15 * 60 * std::sqrt(2), 1e-6);
  EXPECT_NEAR(pixels(0.2), 0.5 * pixels(0.1), 1e-6);
  EXPECT_GT(pixels(0.01), 300) << "narrower, though in pixels of 0.1 mm";
}

TEST(KeyLight, ItsMapIsFinerWhereItsTexelsWouldBeSeenAsStairs) {
  EXPECT_EQ(shadow_resolution(Tier::kRecord, 0, false), 512);
  EXPECT_EQ(shadow_resolution(Tier::kRecord, 1200, false), 512) << "an organ that fills a picture of 1280 by 720";
  EXPECT_EQ(shadow_resolution(Tier::kRecord, 3000, false), 1024);
  EXPECT_EQ(shadow_resolution(Tier::kFinal, 3000, false), 1024);
  EXPECT_EQ(shadow_resolution(Tier::kRecord, 1e6, false), 2048);
  EXPECT_EQ(shadow_resolution(Tier::kFinal, 1e6, false), 2048);
}

TEST(KeyLight, TheMapOfASmallLampWhichShowsToolsIsFiner) {
  EXPECT_EQ(shadow_resolution(Tier::kRecord, 600, true), 512) << "the same in a picture of 640 by 360";
  EXPECT_EQ(shadow_resolution(Tier::kRecord, 1200, true), 1024);
  EXPECT_EQ(shadow_resolution(Tier::kFinal, 1200, true), 1024);
}

TEST(KeyLight, AmongTheTissueKeepsItsWholeView) {
  for (const double most : most_in_map(sheet(), lamp_at({0, 0, 1e-4}))) EXPECT_TRUE(std::isfinite(most));
}

}  // namespace
}  // namespace thinwall
