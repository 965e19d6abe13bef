#include "renderer/camera/CameraMove.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "renderer/camera/Camera.hpp"
#include "renderer/camera/Shot.hpp"
#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

constexpr CameraPose kOwn{.position = {0, -2, 0}, .target = {0, 0, 0}, .up = {0, 0, 1}, .field_of_view = 0.5};

void expect_near(Vector3 a, Vector3 b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

/// From the front at one second to the right at three, looking at a place that moves up.
CameraDefinition quarter_turn(CameraEase ease) {
  return {.keyframes = {{.time = 1, .position = Double3{0, -2, 0}, .target = Double3{0, 0, 0}},
                        {.time = 3,
                         .position = Double3{8, 0, 0.3},
                         .target = Double3{0, 0, 0.3},
                         .field_of_view = 0.7,
                         .ease = ease}}};
}

TEST(CameraMove, AtAKeyframeThePoseIsTheKeyframes) {
  const CameraDefinition camera = quarter_turn(CameraEase::kSmooth);
  const CameraPose first = moved_pose(camera, kOwn, 1);
  EXPECT_EQ(first.position.y, -2);
  EXPECT_EQ(first.field_of_view, 0.5) << "the camera's own";
  const CameraPose second = moved_pose(camera, kOwn, 3);
  EXPECT_EQ(second.position.x, 8);
  EXPECT_EQ(second.target.z, 0.3);
  EXPECT_EQ(second.field_of_view, 0.7);
}

TEST(CameraMove, BeforeTheFirstAndAfterTheLastKeyframeTheCameraStays) {
  const CameraDefinition camera = quarter_turn(CameraEase::kLinear);
  EXPECT_EQ(moved_pose(camera, kOwn, 0).position.y, -2);
  EXPECT_EQ(moved_pose(camera, kOwn, 9).position.x, 8);
}

TEST(CameraMove, HalfwayTheCameraStandsOnTheArcAtTheGeometricMeanOfTheDistances) {
  const CameraPose half = moved_pose(quarter_turn(CameraEase::kLinear), kOwn, 2);
  expect_near(half.target, {0, 0, 0.15}, 1e-15);
  const double distance = std::sqrt(2.0 * 8.0);
  expect_near(half.position, {distance * std::sqrt(0.5), -distance * std::sqrt(0.5), 0.15}, 1e-12);
  EXPECT_NEAR(half.field_of_view, 0.6, 1e-15);
}

TEST(CameraMove, SmoothMovesStartAndEndAtRest) {
  const CameraDefinition camera = quarter_turn(CameraEase::kSmooth);
  const auto angle = [&](double time) {
    const CameraPose pose = moved_pose(camera, kOwn, time);
    return std::atan2(pose.position.x, -pose.position.y);
  };
  // 3 t^2 - 2 t^3 at a quarter of the way is 5 / 32.
  EXPECT_NEAR(angle(1.5), 5.0 / 32 * std::numbers::pi / 2, 1e-12);
  EXPECT_LT(angle(1.001), 1e-5);
  EXPECT_LT(std::numbers::pi / 2 - angle(2.999), 1e-5);
}

TEST(CameraMove, OppositeSidesAreJoinedByWayOfTheHorizon) {
  const CameraDefinition camera{
      .keyframes = {{.time = 0}, {.time = 1, .position = Double3{0, 2, 0}, .ease = CameraEase::kLinear}}};
  const CameraPose half = moved_pose(camera, kOwn, 0.5);
  EXPECT_NEAR(std::abs(half.position.x), 2, 1e-12);
  EXPECT_NEAR(half.position.z, 0, 1e-12);
}

TEST(CameraMove, TravellingWithAToolKeepsLineOfSightAndDistance) {
  const CameraDefinition camera{.follow = CameraFollow{.tool = "probe"}, .followed_point = Double3{0.5, 0.25, 1}};
  const CameraPose pose = moved_pose(camera, kOwn, 0);
  expect_near(pose.target, {0.5, 0.25, 1}, 0);
  expect_near(pose.position, {0.5, -1.75, 1}, 0);
}

TEST(CameraMove, PanningTurnsWhereItStands) {
  const CameraDefinition camera{.follow = CameraFollow{.tool = "probe", .travels = false},
                                .followed_point = Double3{0.5, 0.25, 1}};
  const CameraPose pose = moved_pose(camera, kOwn, 0);
  expect_near(pose.target, {0.5, 0.25, 1}, 0);
  expect_near(pose.position, kOwn.position, 0);
}

TEST(CameraMove, APushInEndsAtItsPartOfTheDistance) {
  const CameraDefinition camera{.push_ins = {{.begin = 1, .end = 2, .factor = 0.25, .ease = CameraEase::kLinear}}};
  expect_near(moved_pose(camera, kOwn, 1).position, {0, -2, 0}, 0);
  expect_near(moved_pose(camera, kOwn, 1.5).position, {0, -1, 0}, 1e-15);
  expect_near(moved_pose(camera, kOwn, 7).position, {0, -0.5, 0}, 1e-15);
}

TEST(CameraMove, TheResolvedCameraStandsWhereTheKeyframeSays) {
  const CameraDefinition camera = quarter_turn(CameraEase::kSmooth);
  const Camera resolved = resolve_camera(camera, {}, {640, 360}, 3);
  expect_near(resolved.position, {8, 0, 0.3}, 0);
  expect_near(resolved.forward, {-1, 0, 0}, 1e-15);
  EXPECT_NEAR(resolved.tangent_y, std::tan(0.35), 1e-15);
  const auto pixel = resolved.pixel({0, 0, 0.3}, {640, 360});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR((*pixel)[0], 320, 1e-9);
  EXPECT_NEAR((*pixel)[1], 180, 1e-9);
}

TEST(CameraMove, AMoveIntoTheTargetIsRefused) {
  const CameraDefinition camera{.keyframes = {{.time = 0, .position = Double3{1, 1, 1}, .target = Double3{1, 1, 1}}}};
  EXPECT_THROW(resolve_camera(camera, {}, {640, 360}, 0), PictureFailure);
}

TEST(Shot, TheLastCutUpToTheTimeCounts) {
  ViewDefinition view;
  view.camera.exposure = 1;
  view.cameras["close"].exposure = 2;
  view.cameras["side"].exposure = 3;
  view.cuts = {{.time = 1, .camera = "close"},
               {.time = 2, .camera = "main", .beside = "side", .inset = "close", .corner = PictureCorner::kLowerLeft}};
  EXPECT_EQ(shot_at(view, 0.999).camera.exposure, 1);
  EXPECT_EQ(shot_at(view, 1).camera.exposure, 2);
  EXPECT_FALSE(shot_at(view, 1.9).inset);
  const Shot last = shot_at(view, 2 - 1e-12);
  EXPECT_EQ(last.camera.exposure, 1) << "what rounding leaves of a sum of time steps counts as the time itself";
  EXPECT_EQ(last.beside->exposure, 3);
  EXPECT_EQ(last.inset->exposure, 2);
  EXPECT_EQ(last.corner, PictureCorner::kLowerLeft);
}

TEST(Shot, ACameraThatThereIsNotIsNamed) {
  ViewDefinition view;
  view.cuts = {{.time = 0, .camera = "absent"}};
  EXPECT_THROW(shot_at(view, 0), PictureFailure);
}

TEST(CameraMove, AnOrbitSetsOutAndComesToRestWithoutAJerk) {
  constexpr double kSpeed = 0.5, kEnd = 4, kStep = 1e-3;  // radians / second, seconds
  const CameraDefinition camera{.orbit_speed = kSpeed, .orbit_end = kEnd};
  const auto speed = [&](double time) {
    return (orbit_angle(camera, time + kStep) - orbit_angle(camera, time - kStep)) / (2 * kStep);
  };
  EXPECT_EQ(orbit_angle(camera, 0), 0);
  EXPECT_NEAR(speed(0), 0, 1e-5) << "at rest";
  EXPECT_NEAR(speed(0.5 * kOrbitEase), 0.5 * kSpeed, 1e-5);
  EXPECT_NEAR(speed(0.5 * kEnd), kSpeed, 1e-9);
  EXPECT_NEAR(speed(kEnd - 0.5 * kOrbitEase), 0.5 * kSpeed, 1e-5);
  EXPECT_NEAR(speed(kEnd), 0, 1e-5) << "at rest again";
  EXPECT_NEAR(orbit_angle(camera, kEnd), kSpeed * (kEnd - kOrbitEase), 1e-12);
  EXPECT_EQ(orbit_angle(camera, kEnd + 1), orbit_angle(camera, kEnd)) << "and stays there";
  for (double time = 0; time < kEnd; time += 0.01) {
    EXPECT_LT(std::abs(speed(time + 0.01) - speed(time)), 0.02 * kSpeed) << time;
  }
}

TEST(CameraMove, AShortOrbitEasesOverHalfOfItsTime) {
  const CameraDefinition camera{.orbit_speed = 1, .orbit_end = 0.6};
  EXPECT_NEAR(orbit_angle(camera, 0.6), 0.3, 1e-12);
  EXPECT_NEAR(orbit_angle(camera, 0.3), 0.15, 1e-12);
  CameraDefinition endless = camera;
  endless.orbit_end.reset();
  EXPECT_NEAR(orbit_angle(endless, 100), 100 - 0.5 * kOrbitEase, 1e-12) << "of one whose end nobody knows";
}

}  // namespace
}  // namespace thinwall
