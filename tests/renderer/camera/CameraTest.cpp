#include "renderer/camera/Camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "renderer/camera/CameraMove.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize{1280, 720};

SceneExtent extent_of(const SnapshotSurface& surface) {
  Snapshot snapshot;
  snapshot.surfaces.push_back(surface);
  return scene_extent(snapshot);
}

SceneExtent box(float x, float y, float z) {
  std::vector<Float3> corners;
  for (const float sx : {-x, x}) {
    for (const float sy : {-y, y}) {
      for (const float sz : {-z, z}) corners.push_back({sx, sy, sz});
    }
  }
  return extent_of(test::surface_of("box", corners, {{0, 1, 2}}));
}

TEST(Camera, APointLandsWhereSimilarTrianglesPutIt) {
  // From (0, -2, 0) towards +y with a right angle of view: half the picture's height shows 2 m at a distance of 2 m.
  const CameraDefinition definition{
      .position = Double3{0, -2, 0}, .target = Double3{0, 0, 0}, .up = {}, .field_of_view = std::numbers::pi / 2};
  const Camera camera = resolve_camera(definition, box(1, 1, 1), {200, 100}, 0);
  const auto pixel = camera.pixel({1, 0, 0.5}, {200, 100});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR((*pixel)[0], 100 + 50 * 0.5, 1e-12);
  EXPECT_NEAR((*pixel)[1], 50 - 50 * 0.25, 1e-12);
  EXPECT_FALSE(camera.pixel({0, -3, 0}, {200, 100})) << "behind the camera";
}

TEST(Camera, TheMatrixAgreesWithThePixel) {
  const Camera camera = resolve_camera({}, box(0.03f, 0.02f, 0.01f), kSize, 0);
  const Vector3 point{0.011, -0.007, 0.004};
  const Matrix4 matrix = camera.matrix();
  double clip[4];
  for (int row = 0; row < 4; ++row) {
    clip[row] = matrix(row, 0) * point.x + matrix(row, 1) * point.y + matrix(row, 2) * point.z + matrix(row, 3);
  }
  const auto pixel = camera.pixel(point, kSize);
  ASSERT_TRUE(pixel);
  // Two ways through a dozen roundings of numbers about 1000.
  EXPECT_NEAR((*pixel)[0], 0.5 * kSize.width * (1 + clip[0] / clip[3]), 1e-9);
  EXPECT_NEAR((*pixel)[1], 0.5 * kSize.height * (1 - clip[1] / clip[3]), 1e-9);
  EXPECT_LT(std::abs(clip[2]), clip[3]) << "between the nearest and the farthest depth";
}

TEST(Camera, LooksDownAsSteeplyAsItIsTold) {
  for (const double elevation : {0.0, 0.4, 1.5}) {
    const Camera camera = resolve_camera({.elevation = elevation}, box(0.03f, 0.02f, 0.01f), kSize, 0);
    EXPECT_NEAR(camera.forward.z, -std::sin(elevation), 1e-12);
    EXPECT_GT(camera.up.z, 0);
  }
}

/// A ball that has been blown up by a factor, about its lowest point.
SceneExtent blown_up(float factor) {
  SnapshotSurface ball = test::sphere("ball", {}, 0.02, 3);
  for (Float3& position : ball.positions) {
    for (float& part : position) part *= factor;
    position[2] += (factor - 1) * 0.02F;
  }
  return extent_of(ball);
}

TEST(Camera, ByDefaultGoesBackForWallsThatGrowOutOfThePicture) {
  for (const CameraKind kind : {CameraKind::kPinhole, CameraKind::kEndoscope}) {
    const CameraDefinition definition{.kind = kind};
    const Camera before = resolve_camera(definition, blown_up(1), kSize, 0);
    EXPECT_EQ(length(resolve_camera(definition, blown_up(1.05F), kSize, 0).position - before.position), 0)
        << "there is room for what grows a little";
    double distance = 0;
    for (const float factor : {1.5F, 2.0F, 2.2F}) {
      const SceneExtent extent = blown_up(factor);
      const Camera camera = resolve_camera(definition, extent, kSize, 0);
      EXPECT_EQ(length(camera.forward - before.forward), 0);
      EXPECT_GT(length(camera.position - before.position), distance);
      distance = length(camera.position - before.position);
      for (const Vector3& point : extent.grown_points) {
        const auto pixel = camera.pixel(point, kSize);
        ASSERT_TRUE(pixel);
        EXPECT_GE((*pixel)[0], 0);
        EXPECT_LE((*pixel)[0], kSize.width);
        EXPECT_GE((*pixel)[1], 0.09 * kSize.height);
        EXPECT_LE((*pixel)[1], 0.91 * kSize.height);
      }
    }
  }
}

TEST(Camera, LeavesRoomForCaptionsThatStandAbovePanels) {
  for (const ImageSize size : {ImageSize{320, 240}, ImageSize{800, 600}, ImageSize{1080, 1080}, ImageSize{1280, 800}}) {
    const SceneExtent extent = blown_up(1);
    const Camera camera = resolve_camera({}, extent, size, 0);
    for (const Vector3& point : extent.rest_points) {
      const auto pixel = camera.pixel(point, size);
      ASSERT_TRUE(pixel);
      // Margin, panels, a gap and a caption of one line, in 720ths of the height: see Plate.hpp.
      EXPECT_LE((*pixel)[1], (720 - 26 - 172 - 22 - 48) / 720.0 * size.height);
      EXPECT_GE((*pixel)[1], 66 / 720.0 * size.height) << "below the title";
    }
  }
}

TEST(Camera, OneThatNobodyPlacedGoesByWhatIsNotSceneryAndSeesThatToo) {
  const SnapshotSurface ball = test::sphere("ball", {}, 0.02, 3);
  SnapshotSurface ground = test::sphere("ground", {0.1, 0.05, -0.3}, 0.25, 3);
  Snapshot snapshot;
  snapshot.surfaces = {ball, ground};
  const CameraDefinition definition{.kind = CameraKind::kEndoscope};
  const Camera alone = resolve_camera(definition, extent_of(ball), kSize, 0);
  const Camera of_both = resolve_camera(definition, scene_extent(snapshot), kSize, 0);
  auto topology = std::make_shared<SnapshotTopology>(*ground.topology);
  topology->is_scenery = true;
  snapshot.surfaces[1].topology = topology;
  const Camera dressed = resolve_camera(definition, scene_extent(snapshot), kSize, 0);
  EXPECT_GT(length(of_both.position - alone.position), 0.2);
  EXPECT_EQ(length(dressed.position - alone.position), 0);
  EXPECT_EQ(length(dressed.forward - alone.forward), 0);
  EXPECT_EQ(dressed.focus, alone.focus);
  EXPECT_GT(dressed.farthest, 0.5) << "all of the ground";
  // Where nothing else is it is what the picture is of.
  snapshot.surfaces.erase(snapshot.surfaces.begin());
  EXPECT_EQ(length(resolve_camera(definition, scene_extent(snapshot), kSize, 0).position -
                   resolve_camera(definition, extent_of(ground), kSize, 0).position),
            0);
}

TEST(Camera, GoesBackOnlySoFarForAWallThatFliesAway) {
  const Camera before = resolve_camera({}, blown_up(1), kSize, 0);
  const Camera camera = resolve_camera({}, blown_up(1000), kSize, 0);
  EXPECT_LT(-dot(camera.position, camera.forward), 3.1 * -dot(before.position, before.forward));
}

TEST(Camera, StaysWhereItIsPutWhileWallsGrow) {
  const CameraDefinition definition{.position = Double3{0, -0.2, 0}};
  EXPECT_EQ(resolve_camera(definition, blown_up(3), kSize, 0).position.y, -0.2);
}

TEST(Camera, ByDefaultAllRestPointsAreSeenAndFillTheRoomBetweenTheOverlays) {
  for (const SceneExtent& extent : {box(0.03f, 0.02f, 0.01f), box(0.001f, 0.002f, 0.02f), box(2, 9, 1)}) {
    for (const ImageSize size : {kSize, ImageSize{400, 900}}) {
      const Camera camera = resolve_camera({}, extent, size, 0);
      EXPECT_GT(camera.position.z, extent.center.z) << "seen from above";
      double left = 1, right = -1, top = -1, bottom = 1;
      for (const Vector3& point : extent.rest_points) {
        const auto pixel = camera.pixel(point, size);
        ASSERT_TRUE(pixel);
        left = std::min(left, 2 * (*pixel)[0] / size.width - 1);
        right = std::max(right, 2 * (*pixel)[0] / size.width - 1);
        top = std::max(top, 1 - 2 * (*pixel)[1] / size.height);
        bottom = std::min(bottom, 1 - 2 * (*pixel)[1] / size.height);
      }
      // The window of Camera.cpp; one of its two spans is used up, to rounding.
      EXPECT_GE(left, -0.80 - 1e-9);
      EXPECT_LE(right, 0.60 + 1e-9);
      EXPECT_GE(bottom, -0.64 - 1e-9);
      EXPECT_LE(top, 0.56 + 1e-9);
      EXPECT_NEAR(std::max((right - left) / 1.40, (top - bottom) / 1.20), 1, 1e-9);
    }
  }
}

TEST(Camera, OrbitTurnsAroundTheTargetAndKeepsTheDistance) {
  CameraDefinition definition{
      .position = Double3{1, 0, 0.5}, .target = Double3{0, 0, 0}, .up = {}, .orbit_speed = std::numbers::pi};
  // A quarter turn, half of the time of setting out later than without.
  const Camera camera = resolve_camera(definition, box(0.1f, 0.1f, 0.1f), kSize, 0.5 + 0.5 * kOrbitEase);
  EXPECT_NEAR(camera.position.x, 0, 1e-15);
  EXPECT_NEAR(camera.position.y, 1, 1e-15);
  EXPECT_NEAR(camera.position.z, 0.5, 1e-15);
  const auto pixel = camera.pixel({0, 0, 0}, kSize);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR((*pixel)[0], 640, 1e-9);
  EXPECT_NEAR((*pixel)[1], 360, 1e-9);
}

TEST(Camera, OneThatNobodyPlacedHoldsAllOnItsWayRound) {
  const SceneExtent extent = box(0.06F, 0.015F, 0.02F);
  double before = 0;
  for (const double speed : {0.5, -0.5}) {
    for (int step = 0; step <= 40; ++step) {
      const Camera camera = resolve_camera({.orbit_speed = speed}, extent, kSize, 0.5 * step);
      for (const Vector3& point : extent.rest_points) {
        const auto pixel = camera.pixel(point, kSize);
        ASSERT_TRUE(pixel);
        // Of what is between the angles that are looked at, every 5 degrees.
        constexpr double kBetween = 1e-3;
        EXPECT_GE((*pixel)[0] / 640 - 1, -0.80 - kBetween) << step;
        EXPECT_LE((*pixel)[0] / 640 - 1, 0.60 + kBetween) << step;
        EXPECT_GE((*pixel)[1] / 360 - 1, -0.56 - kBetween) << step;
        EXPECT_LE((*pixel)[1] / 360 - 1, 0.64 + kBetween) << step;
      }
      const double distance = dot(extent.center - camera.position, camera.forward);
      EXPECT_GE(distance, step == 0 ? 0 : 0.999 * before) << "it never comes back";
      before = distance;
    }
    const Camera still = resolve_camera({}, extent, kSize, 0);
    EXPECT_LT(before, 1.6 * dot(extent.center - still.position, still.forward));
  }
}

/// A level rectangle of two triangles, one of which `cuts` have divided at one of its ends in y; or as it lies where up
/// is +y, and what was +y is -z.
SceneExtent rectangle(float x, float y, int cuts, bool is_turned = false) {
  std::vector<Float3> corners = {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}};
  std::vector<Triangle> triangles = {{0, 2, 3}};
  std::uint32_t last = 0;
  for (int k = 0; k < cuts; ++k) {
    const auto next = static_cast<std::uint32_t>(corners.size());
    corners.push_back({0.1F * x * static_cast<float>(k) / static_cast<float>(cuts), -y, 0});
    triangles.push_back({last, next, 2});
    last = next;
  }
  triangles.push_back({last, 1, 2});
  if (is_turned)
    std::ranges::transform(corners, corners.begin(), [](Float3 at) { return Float3{at[0], at[2], -at[1]}; });
  return extent_of(test::surface_of("rectangle", corners, triangles));
}

TEST(Camera, OneThatNobodyPlacedLooksAcrossWhatIsLongAndStaysThereWhenCutsDivideTriangles) {
  for (const auto& [x, y] : {std::pair{1.0F, 1.0F}, {2.0F, 1.0F}, {1.0F, 2.0F}}) {
    SCOPED_TRACE(y);
    const Vector3 whole = resolve_camera({}, rectangle(x, y, 0), kSize, 0).forward;
    EXPECT_EQ(std::abs(whole.x) > std::abs(whole.y), y > x);
    const Vector3 cut = resolve_camera({}, rectangle(x, y, 50), kSize, 0).forward;
    EXPECT_NEAR(length(cut - whole), 0, 1e-12);
  }
}

TEST(Camera, OneThatNobodyPlacedTurnsWithWhatIsUp) {
  for (const auto& [x, y] : {std::pair{2.0F, 1.0F}, {1.0F, 2.0F}}) {
    const Camera upright = resolve_camera({}, rectangle(x, y, 0), kSize, 0);
    const Camera over = resolve_camera({.up = Double3{0, 1, 0}}, rectangle(x, y, 0, true), kSize, 0);
    for (const auto& [was, is] :
         {std::pair(upright.forward, over.forward), std::pair(upright.position, over.position)}) {
      EXPECT_NEAR(length(is - Vector3{was.x, was.z, -was.y}), 0, 1e-12) << "long in " << (x > y ? "x" : "y");
    }
  }
}

TEST(Camera, AViewStraightDownHasADirection) {
  const CameraDefinition definition{.position = Double3{0, 0, 1}, .target = Double3{0, 0, 0}, .up = {}};
  const Camera camera = resolve_camera(definition, box(0.1f, 0.1f, 0.1f), kSize, 0);
  EXPECT_NEAR(length(camera.right), 1, 1e-15);
  EXPECT_NEAR(length(camera.up), 1, 1e-15);
}

TEST(Camera, WhatShowsNothingIsRefused) {
  const CameraDefinition at_target{.position = Double3{0, 0, 1}, .target = Double3{0, 0, 1}, .up = {}};
  EXPECT_THROW(resolve_camera(at_target, box(1, 1, 1), kSize, 0), PictureFailure);
  try {
    resolve_camera({.position = Double3{0, 0, 0}}, box(1, 1, 1), kSize, 0);
    FAIL() << "a camera in the middle of the bodies looks somewhere without a target";
  } catch (const PictureFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("give it a `target`"), std::string::npos) << failure.what();
  }
  for (const double angle : {0.0, -1.0, std::numbers::pi, std::nan("")}) {
    const CameraDefinition definition{.position = {}, .target = {}, .up = {}, .field_of_view = angle};
    EXPECT_THROW(resolve_camera(definition, box(1, 1, 1), kSize, 0), PictureFailure);
  }
}

}  // namespace
}  // namespace thinwall
