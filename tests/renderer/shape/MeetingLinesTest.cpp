#include "renderer/shape/MeetingLines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/snapshot/Vector.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

/// Walls that share their vertices, as in a scene.
struct Walls {
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint32_t> first, second;

  void add(const SnapshotSurface& surface, std::vector<std::uint32_t>& corners) {
    const auto offset = static_cast<std::uint32_t>(vertices.size());
    for (const Float3& position : surface.positions) vertices.emplace_back().position = position;
    for (const Triangle& triangle : surface.topology->triangles) {
      for (const std::uint32_t corner : triangle) corners.push_back(offset + corner);
    }
  }
  MeetingWall wall(const std::vector<std::uint32_t>& corners) const {
    std::vector<SurfaceVertex> own;
    for (const std::uint32_t corner : corners) own.push_back(vertices[corner]);
    return {corners, bounds_of(own)};
  }
  /// Seen from far above.
  std::vector<OutlineSegment> lines() const {
    std::vector<OutlineSegment> lines;
    append_meeting_lines(vertices, wall(first), wall(second), {0, 0, 1e3}, lines);
    return lines;
  }
};

double length_of(const std::vector<OutlineSegment>& lines) {
  double sum = 0;
  for (const OutlineSegment& line : lines) sum += length(vector3(line.end) - vector3(line.start));
  return sum;
}

Walls two_balls(double apart) {
  Walls walls;
  walls.add(test::sphere("one", {0, 0, 0}, 0.02, 4), walls.first);
  walls.add(test::sphere("other", {apart, 0.0003, 0.0002}, 0.02, 4), walls.second);
  return walls;
}

TEST(MeetingLines, TwoBallsMeetInACircleOfWhichTheHalfThatFacesTheEyeIsSeen) {
  const std::vector<OutlineSegment> lines = two_balls(0.02).lines();
  // Half way between balls of 20 mm whose middles are as far from each other, sqrt(3) / 2 as large as they.
  const double circumference = 2 * std::numbers::pi * 0.02 * std::sqrt(0.75);
  constexpr double kFlat = 8e-5;  // metres, by which triangles with sides of 3 mm lie within their ball
  for (const OutlineSegment& line : lines) {
    for (const Float3& end : {line.start, line.end}) {
      EXPECT_NEAR(length(vector3(end)), 0.02, kFlat);
      EXPECT_NEAR(length(vector3(end) - Vector3{0.02, 0.0003, 0.0002}), 0.02, kFlat);
    }
  }
  // Where the half ends it ends with a triangle.
  EXPECT_NEAR(length_of(lines), 0.5 * circumference, 0.02 * circumference) << "all of it, and once";
}

TEST(MeetingLines, BallsBesideAndWithinEachOtherMeetNowhere) {
  EXPECT_TRUE(two_balls(0.045).lines().empty());
  Walls within;
  within.add(test::sphere("one", {0, 0, 0}, 0.02, 3), within.first);
  within.add(test::sphere("other", {0.001, 0, 0}, 0.01, 3), within.second);
  EXPECT_TRUE(within.lines().empty());
}

TEST(MeetingLines, ALineOfTwoTrianglesEndsAtTheirSides) {
  Walls walls;
  // Level, and nearly upright along x through its middle.
  const std::vector<Float3> places = {{-1, -1, 0},     {1, -1, 0},     {0, 1, 0},
                                      {-2, -0.1F, -1}, {2, -0.1F, -1}, {0, 0.1F, 1}};
  for (const Float3& place : places) walls.vertices.emplace_back().position = place;
  walls.first = {0, 1, 2};
  walls.second = {3, 4, 5};
  const std::vector<OutlineSegment> lines = walls.lines();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(std::min(lines[0].start[0], lines[0].end[0]), -0.5, 1e-6);
  EXPECT_NEAR(std::max(lines[0].start[0], lines[0].end[0]), 0.5, 1e-6);
  walls.second = {0, 2, 1};
  EXPECT_TRUE(walls.lines().empty()) << "in one plane";
}

}  // namespace
}  // namespace thinwall
