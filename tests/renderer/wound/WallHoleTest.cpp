#include "renderer/wound/WallHole.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/wound/FluidLevel.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

/// A ball without the triangles above `height`.
SnapshotSurface bowl(double height) {
  const SnapshotSurface ball = test::sphere("bowl", {0, 0, 0}, 1, 4);
  std::vector<Triangle> kept;
  for (const Triangle& triangle : ball.topology->triangles) {
    bool below = false;
    for (const std::uint32_t vertex : triangle) below = below || ball.positions[vertex][2] < height;
    if (below) kept.push_back(triangle);
  }
  return test::surface_of("bowl", ball.positions, kept);
}

TEST(WallHole, OfAClosedWallIsNone) {
  const SnapshotSurface ball = test::sphere("ball", {0, 0, 0}, 1, 2);
  EXPECT_TRUE(find_wall_holes(ball.positions, border_edges(*ball.topology)).empty());
}

TEST(WallHole, LidClosesTheSurface) {
  const SnapshotSurface open = bowl(0.5);
  const std::vector<WallHole> holes = find_wall_holes(open.positions, border_edges(*open.topology));
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_EQ(holes[0].lid.size(), holes[0].loop.size() - 2);
  SnapshotTopology closed = *open.topology;
  closed.triangles.insert(closed.triangles.end(), holes[0].lid.begin(), holes[0].lid.end());
  EXPECT_TRUE(border_edges(closed).empty()) << "each edge of the lid has its counterpart";
}

TEST(WallHole, LidOfABentSlitStaysBetweenItsLips) {
  // An arch of 21 places with lips 0.1 apart: no edge of the lid is longer than a step along and across.
  std::vector<Float3> positions;
  std::vector<BorderEdge> borders;
  constexpr std::uint32_t kSteps = 20;
  for (std::uint32_t k = 0; k <= kSteps; ++k) {
    const float angle = 3.0f * static_cast<float>(k) / kSteps;
    positions.push_back({std::cos(angle), std::sin(angle), 0});
  }
  for (std::uint32_t k = 1; k < kSteps; ++k) {
    const float angle = 3.0f * static_cast<float>(k) / kSteps;
    positions.push_back({1.1f * std::cos(angle), 1.1f * std::sin(angle), 0});
  }
  std::vector<std::uint32_t> loop;
  for (std::uint32_t k = 0; k <= kSteps; ++k) loop.push_back(k);
  for (std::uint32_t k = kSteps - 1; k >= 1; --k) loop.push_back(kSteps + k);
  for (std::size_t k = 0; k < loop.size(); ++k) {
    borders.push_back({.start = loop[k], .end = loop[(k + 1) % loop.size()], .triangle = 0});
  }
  const std::vector<WallHole> holes = find_wall_holes(positions, borders);
  ASSERT_EQ(holes.size(), 1U);
  for (const Triangle& triangle : holes[0].lid) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LT(length(vector3(positions[triangle[k]]) - vector3(positions[triangle[(k + 1) % 3]])), 0.25);
    }
  }
}

TEST(WallHole, ItsMouthIsTheLidWhereNoFlapStandsOut) {
  const SnapshotSurface open = bowl(0.5);
  const std::vector<WallHole> holes = find_wall_holes(open.positions, border_edges(*open.topology));
  const HoleMouth mouth = mouth_of(holes[0], open.positions);
  EXPECT_EQ(mouth.lid, holes[0].lid);
  EXPECT_GT(mouth.outward.z, 0.99);
}

TEST(WallHole, ItsMouthLeavesOutAFlapThatStandsUp) {
  SnapshotSurface open = bowl(0.5);
  const std::vector<WallHole> holes = find_wall_holes(open.positions, border_edges(*open.topology));
  const std::uint32_t tip = holes[0].loop[5];
  open.positions[tip][2] += 0.8F;
  const HoleMouth mouth = mouth_of(find_wall_holes(open.positions, border_edges(*open.topology))[0], open.positions);
  EXPECT_EQ(mouth.lid.size(), holes[0].lid.size() - 1);
  for (const Triangle& triangle : mouth.lid) EXPECT_EQ(std::ranges::count(triangle, tip), 0);
}

}  // namespace
}  // namespace thinwall
