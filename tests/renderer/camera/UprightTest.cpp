#include "renderer/camera/Upright.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

void expect_near(Vector3 a, Vector3 b, double most, const char* what) {
  EXPECT_NEAR(length(a - b), 0, most) << what;
}

/// Of y upwards.
Snapshot standing_ball() {
  Snapshot snapshot;
  snapshot.gravity = {0, -9.81, 0};
  snapshot.surfaces = {test::sphere("organ", {0.01F, 0.02F, 0.03F}, 0.02F, 2)};
  snapshot.tools = {
      {.name = "needle", .tip = {1, 2, 3}, .direction = {0, -1, 0}, .axis = {0, 0, 1}, .force = {0, 5, 0}}};
  return snapshot;
}

TEST(Upright, IsWhatHasAGroundBelowItAlready) {
  EXPECT_FALSE(turn_upright({0, 0, 0}));
  EXPECT_FALSE(turn_upright({0, 0, -9.81}));
  EXPECT_FALSE(turn_upright({0, -5, -9}));
  EXPECT_TRUE(turn_upright({0, -9, -5}));
}

TEST(Upright, TurnsWithoutMirroringUntilGravityPullsDownwards) {
  for (const Double3& gravity :
       {Double3{0, -9.81, 0}, Double3{0, 9.81, 0}, Double3{-9.81, 0, 0}, Double3{0, 0, 9.81}, Double3{3, -7, 2}}) {
    const Turn turn = turn_upright(gravity).value();
    expect_near(turn.of(normalized(vector3(gravity))), {0, 0, -1}, 1e-15, "down");
    expect_near(cross(turn.x, turn.y), turn.z, 1e-15, "the third axis");
    EXPECT_NEAR(length(turn.x), 1, 1e-15);
    EXPECT_NEAR(length(turn.y), 1, 1e-15);
  }
}

TEST(Upright, LeavesRightWhatIsRightWhereYIsUp) {
  const Turn turn = turn_upright({0, -9.81, 0}).value();
  expect_near(turn.of({1, 2, 3}), {1, -3, 2}, 0, "z comes towards the viewer, who is at -y");
}

TEST(Upright, TurnsAllPlacesAndDirectionsOfASnapshot) {
  const Snapshot given = standing_ball();
  const Turn turn = turn_upright(given.gravity).value();
  Turner turner;
  const Snapshot upright = turner.turned(given, turn);
  const auto expect_turned = [&](const auto& before, const auto& after, const char* what) {
    expect_near(vector3(after), turn.of(vector3(before)), 1e-9, what);
  };
  expect_turned(given.gravity, upright.gravity, "gravity");
  const SnapshotSurface &wall = given.surfaces[0], &turned_wall = upright.surfaces[0];
  expect_turned(wall.positions[7], turned_wall.positions[7], "position");
  expect_turned(wall.topology->rest_positions[7], turned_wall.topology->rest_positions[7], "stress-free position");
  const SnapshotTool &tool = given.tools[0], &turned_tool = upright.tools[0];
  expect_turned(tool.tip, turned_tool.tip, "tip");
  expect_turned(tool.direction, turned_tool.direction, "direction");
  expect_turned(tool.axis, turned_tool.axis, "axis");
  expect_turned(tool.force, turned_tool.force, "force");
  EXPECT_EQ(turner.turned(given, turn).surfaces[0].topology, turned_wall.topology);
}

TEST(Upright, AnotherGravityTurnsTopologiesAnew) {
  Snapshot given = standing_ball();
  Turner turner;
  turner.turned(given, turn_upright(given.gravity).value());
  given.gravity = {-9.81, 0, 0};
  const Turn turn = turn_upright(given.gravity).value();
  const SnapshotTopology& upright = *turner.turned(given, turn).surfaces[0].topology;
  expect_near(vector3(upright.rest_positions[7]), turn.of(vector3(given.surfaces[0].topology->rest_positions[7])), 1e-9,
              "stress-free position");
}

TEST(Upright, ACameraSeesTheTurnedSceneWhereItSawThatWhichWasGiven) {
  constexpr ImageSize kPicture{320, 180};
  const Snapshot given = standing_ball();
  ViewDefinition view;
  view.lights.key_direction = Double3{0, 1, 0};
  view.highlights = {{.center = {0, 3, 0}}};
  const SeenScene seen = seen_scene(given, view, view.camera, kPicture);
  const Turn turn = turn_upright(given.gravity).value();
  const Snapshot upright = Turner().turned(given, turn);
  const SeenScene turned_seen = turned(seen, upright, turn);
  for (std::size_t v = 0; v < given.surfaces[0].positions.size(); ++v) {
    const auto before = seen.camera.pixel(vector3(given.surfaces[0].positions[v]), kPicture);
    const auto after = turned_seen.camera.pixel(vector3(upright.surfaces[0].positions[v]), kPicture);
    ASSERT_TRUE(before && after);
    // Positions are floats: 1e-9 metres are 1e-5 pixels here.
    EXPECT_NEAR((*before)[0], (*after)[0], 1e-4);
    EXPECT_NEAR((*before)[1], (*after)[1], 1e-4);
  }
  EXPECT_NEAR(turned_seen.extent.floor_height, 0.02 - 0.02, 1e-8) << "the lowest along gravity";
  expect_near(vector3(*turned_seen.view.lights.key_direction), {0, 0, 1}, 0, "the lamp's direction");
  expect_near(vector3(turned_seen.view.highlights[0].center), {0, 0, 3}, 0, "the middle of what is marked");
}

}  // namespace
}  // namespace thinwall
