#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/mesh/Shapes.hpp"
#include "engine/tool/FirstContact.hpp"
#include "tests/engine/tool/TestSurface.hpp"

namespace thinwall {
namespace {

ToolDefinition line(double length) {
  return {.name = "edge", .kind = ToolKind::kLine, .length = length, .radius = 0};
}

std::optional<double> travel(const TestSurface& surface, double length, const ToolPose& pose,
                             const Eigen::Vector3d& motion) {
  return travel_to_contact(surface.view(), line(length), pose, motion);
}

TEST(LineContact, MeetsTheCrownOfASemicylinderAlongItsWholeLength) {
  const TestSurface pad(make_semicylinder(10e-3, 10e-3, 500));
  const auto hit = travel(pad, 20e-3, {.tip = {0, 0, 15e-3}}, kDown);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(*hit, 5e-3, 1e-15);
}

TEST(LineContact, MeetsTheFlankWhereTheChordsAre) {
  // Off the crown the wall is a chord of the circle of 10 mm: below the circle by less than its sagitta.
  const TestSurface pad(make_semicylinder(10e-3, 10e-3, 500));
  const double x = 6e-3;
  const auto hit = travel(pad, 20e-3, {.tip = {x, 0, 15e-3}}, kDown);
  ASSERT_TRUE(hit);
  const double circle = 15e-3 - std::sqrt(1e-4 - x * x);
  EXPECT_GE(*hit, circle - 1e-12);
  EXPECT_LT(*hit, circle + 0.2e-3);
}

TEST(LineContact, AcrossARidgeMeetsTheRidgeOnly) {
  // A line laid along x across the semicylinder touches the crown in the middle of its length.
  const TestSurface pad(make_semicylinder(10e-3, 10e-3, 500));
  const auto hit =
      travel(pad, 4e-3, {.tip = {1e-3, 0, 15e-3}, .direction = kDown, .axis = Eigen::Vector3d::UnitX()}, kDown);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(*hit, 5e-3, 1e-15);
  // Beside the ridge it meets the wall with its end.
  const auto end =
      travel(pad, 4e-3, {.tip = {6e-3, 0, 15e-3}, .direction = kDown, .axis = Eigen::Vector3d::UnitX()}, kDown);
  ASSERT_TRUE(end);
  const double circle = 15e-3 - std::sqrt(1e-4 - 16e-6);
  EXPECT_GE(*end, circle - 1e-12);
  EXPECT_LT(*end, circle + 0.2e-3);
}

TEST(LineContact, MeetsNothingBeyondItsEndsAndNothingAlongItself) {
  const TestSurface cube(unit_cube());
  EXPECT_TRUE(travel(cube, 2, {.tip = {0.5, 1.9, 3}}, kDown));
  EXPECT_FALSE(travel(cube, 2, {.tip = {0.5, 2.1, 3}}, kDown));
  EXPECT_FALSE(travel(cube, 2, {.tip = {0.5, 0.5, 3}}, Eigen::Vector3d::UnitY()));
}

TEST(LineContact, SlantingMotionTravelsFartherByTheSlant) {
  // Only the motion across the line counts: along (0, 0.6, -0.8) it sinks 0.8 per length.
  const TestSurface cube(unit_cube());
  const auto hit = travel(cube, 1, {.tip = {0.5, 0.5, 3}}, Eigen::Vector3d(0, 0.6, -0.8));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(*hit, 2 / 0.8, 1e-14);
}

TEST(LineCrossings, AlongARowOfVerticesAreThoseVertices) {
  const SurfaceMesh mesh = make_semicylinder(10e-3, 10e-3, 500);
  const TestSurface pad(mesh);
  const auto crossings = line_crossings(pad.view(), line(20e-3), {.tip = {0, 0, 9e-3}});
  const auto crown = std::count_if(mesh.vertices.begin(), mesh.vertices.end(),
                                   [](const Eigen::Vector3d& v) { return std::abs(v.x()) < 1e-9 && v.z() > 9.9e-3; });
  ASSERT_EQ(static_cast<long>(crossings.size()), crown);
  std::vector<double> along;
  for (const LineCrossing& crossing : crossings) {
    EXPECT_EQ(crossing.weights.maxCoeff(), 1);
    EXPECT_NEAR(crossing.travel, -1e-3, 1e-15);  // the tool's tip is 1 mm below the crown
    EXPECT_NEAR(pad.point(crossing.triangle, crossing.weights).y(), crossing.along, 1e-15);
    along.push_back(crossing.along);
  }
  std::sort(along.begin(), along.end());
  EXPECT_NEAR(along.front(), -5e-3, 1e-15);
  EXPECT_NEAR(along.back(), 5e-3, 1e-15);
  EXPECT_EQ(std::adjacent_find(along.begin(), along.end()), along.end());  // each once
}

TEST(LineCrossings, BetweenVerticesLieOnThePlaneOfMotionAndOnEdges) {
  const TestSurface pad(make_semicylinder(10e-3, 10e-3, 500));
  const double x = 2.3e-3;
  const auto crossings = line_crossings(pad.view(), line(6e-3), {.tip = {x, 0, 9e-3}});
  ASSERT_GE(crossings.size(), 5u);
  for (const LineCrossing& crossing : crossings) {
    const Eigen::Vector3d point = pad.point(crossing.triangle, crossing.weights);
    EXPECT_NEAR(crossing.weights.sum(), 1, 1e-15);
    EXPECT_EQ(crossing.weights.minCoeff(), 0);  // on an edge
    if (crossing.weights.maxCoeff() < 1) {
      EXPECT_NEAR(point.x(), x, 1e-15);
    }
    EXPECT_LE(std::abs(crossing.along), 3e-3 * (1 + 1e-9));
    EXPECT_NEAR(crossing.along, point.y(), 1e-15);
    EXPECT_NEAR(crossing.travel, 9e-3 - point.z(), 1e-15);
    EXPECT_GT(point.z(), 0);
  }
}

TEST(LineCrossings, LeaveOutTheSideThatFacesAway) {
  // The plane also cuts the bottom of the cube; a line that comes from above does not meet it.
  const TestSurface cube(unit_cube());
  const auto crossings = line_crossings(cube.view(), line(3), {.tip = {0.4, 0.5, 0.9}});
  ASSERT_FALSE(crossings.empty());
  for (const LineCrossing& crossing : crossings) {
    EXPECT_NEAR(cube.point(crossing.triangle, crossing.weights).z(), 1, 1e-15);
  }
}

TEST(LineCrossings, AreOnBothSidesOfAnOpenSurface) {
  for (const double side : {1.0, -1.0}) {
    const ToolPose pose{.tip = {0.1e-3, 0, side * 1e-3}, .direction = Eigen::Vector3d(0, 0, -side)};
    const TestSurface open(make_sheet(20e-3, 20e-3, 200), true);
    EXPECT_FALSE(line_crossings(open.view(), line(6e-3), pose).empty()) << side;
    const TestSurface closed(make_sheet(20e-3, 20e-3, 200));
    EXPECT_EQ(line_crossings(closed.view(), line(6e-3), pose).empty(), side < 0);
  }
}

}  // namespace
}  // namespace thinwall
