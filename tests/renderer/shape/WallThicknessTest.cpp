#include "renderer/shape/WallThickness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "renderer/snapshot/Vector.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

/// A unit square in z = 0 that faces up, of the given thickness.
SnapshotSurface square(float thickness) {
  SnapshotSurface surface = test::quad("sheet", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  auto topology = std::make_shared<SnapshotTopology>(*surface.topology);
  topology->thickness = {thickness, thickness};
  surface.topology = topology;
  return surface;
}

WallDepth depth_of(const SnapshotSurface& surface) {
  const std::vector<SurfaceVertex> wall = wall_vertices(surface);
  const std::vector<BorderEdge> borders = border_edges(*surface.topology);
  return wall_depth(surface, wall, borders, wall_ways(surface, wall, borders));
}

TEST(BorderEdges, AreThoseOfOneTriangleAndNotWhereACapBegins) {
  const SnapshotSurface surface = square(0.1f);
  const std::vector<BorderEdge> borders = border_edges(*surface.topology);
  ASSERT_EQ(borders.size(), 4u);
  EXPECT_EQ(borders[0].start, 0u);
  EXPECT_EQ(borders[0].end, 1u);
  SnapshotTopology capped = *surface.topology;
  capped.cap_triangles = {{0, 2, 1}, {0, 3, 2}};
  EXPECT_TRUE(border_edges(capped).empty());
  EXPECT_TRUE(border_edges(*test::sphere("organ", {}, 1, 2).topology).empty());
}

TEST(WallDepth, TheLiningLiesBehindAndTheRimJoinsIt) {
  const WallDepth depth = depth_of(square(0.1f));
  ASSERT_EQ(depth.lining.size(), 4u);
  for (const SurfaceVertex& vertex : depth.lining) {
    EXPECT_FLOAT_EQ(vertex.position[2], -0.1f);
    EXPECT_EQ(vertex.normal, (Float3{0, 0, -1}));
  }
  ASSERT_EQ(depth.rim.size(), 16u);
  ASSERT_EQ(depth.rim_corners.size(), 24u);
  // The border meets itself at right angles: each side keeps its own normal, out of the square, and its triangles are
  // counter-clockwise seen from there.
  for (std::size_t i = 0; i < depth.rim_corners.size(); i += 3) {
    const SurfaceVertex &a = depth.rim[depth.rim_corners[i]], &b = depth.rim[depth.rim_corners[i + 1]],
                        &c = depth.rim[depth.rim_corners[i + 2]];
    const Vector3 normal = vector3(a.normal);
    const Vector3 outward = vector3(a.position) - Vector3{0.5, 0.5, -0.05};
    EXPECT_GT(dot(normal, outward), 0.4);
    EXPECT_GT(dot(normal, cross(vector3(b.position) - vector3(a.position), vector3(c.position) - vector3(a.position))),
              0.09);
    EXPECT_EQ(a.normal, b.normal);
  }
}

TEST(WallDepth, AStretchedWallIsThinnerAndKeepsItsVolume) {
  SnapshotSurface surface = square(0.1f);
  for (Float3& position : surface.positions) position[0] *= 2;
  for (const SurfaceVertex& vertex : depth_of(surface).lining) EXPECT_FLOAT_EQ(vertex.position[2], -0.05f);
}

TEST(WallDepth, AWallThatIsCrushedGrowsThickerByHalfAtMost) {
  SnapshotSurface surface = square(0.1f);
  for (Float3& position : surface.positions) position[0] *= 0.8f;
  for (const SurfaceVertex& vertex : depth_of(surface).lining) EXPECT_FLOAT_EQ(vertex.position[2], -0.125f);
  for (Float3& position : surface.positions) position[0] *= 0.1f;
  for (const SurfaceVertex& vertex : depth_of(surface).lining) EXPECT_FLOAT_EQ(vertex.position[2], -0.15f);
}

/// Two unit squares of 0.1 thickness that face away from each other, `apart` from each other.
SnapshotSurface collapsed(float apart) {
  SnapshotSurface surface = square(0.1f);
  auto topology = std::make_shared<SnapshotTopology>(*surface.topology);
  for (const Float3& corner : square(0.1f).positions) surface.positions.push_back({corner[0], corner[1], -apart});
  topology->rest_positions = surface.positions;
  topology->triangles.insert(topology->triangles.end(), {{4, 6, 5}, {4, 7, 6}});
  topology->thickness.assign(4, 0.1f);
  surface.topology = topology;
  return surface;
}

TEST(WallDepth, TheInnerSideOfAWallThatLiesAgainstAnotherDoesNotComeOutOfThat) {
  for (const float apart : {0.12f, 0.05f, 0.001f}) {
    const WallDepth depth = depth_of(collapsed(apart));
    ASSERT_EQ(depth.lining.size(), 8u);
    for (std::size_t v = 0; v < 8; ++v) {
      const float below = -depth.lining[v].position[2], behind = v < 4 ? below : apart - below;
      EXPECT_GT(behind, 0.5f * apart) << "vertex " << v << " of walls " << apart << " apart";
      EXPECT_LT(behind, 0.9f * apart) << "vertex " << v << " of walls " << apart << " apart";
    }
  }
  for (const SurfaceVertex& vertex : depth_of(collapsed(0.19f)).lining) {
    EXPECT_FLOAT_EQ(std::min(-vertex.position[2], 0.19f + vertex.position[2]), 0.09f) << "as thick as it is";
  }
}

TEST(WallDepth, ASharpBendIsDrawnSoThinThatItsInnerSideIsNotTurnedOver) {
  // Half a pipe of radius 0.1, bent outwards around less than its own thickness.
  std::vector<Float3> positions;
  std::vector<Triangle> triangles;
  for (std::uint32_t k = 0; k <= 8; ++k) {
    const double angle = k * 0.39269908169872414;
    for (const float y : {0.0f, 0.1f}) {
      positions.push_back({static_cast<float>(-0.1 * std::cos(angle)), y, static_cast<float>(0.1 * std::sin(angle))});
    }
    if (k == 8) continue;
    triangles.push_back({2 * k, 2 * k + 2, 2 * k + 1});
    triangles.push_back({2 * k + 1, 2 * k + 2, 2 * k + 3});
  }
  SnapshotSurface pipe = test::surface_of("pipe", positions, triangles);
  auto topology = std::make_shared<SnapshotTopology>(*pipe.topology);
  topology->thickness.assign(triangles.size(), 0.3f);
  pipe.topology = topology;
  const WallDepth depth = depth_of(pipe);
  for (const Triangle& triangle : triangles) {
    const auto normal = [&](const auto& at) {
      return cross(vector3(at(1)) - vector3(at(0)), vector3(at(2)) - vector3(at(0)));
    };
    const Vector3 outer = normal([&](std::size_t k) { return pipe.positions[triangle[k]]; });
    const Vector3 inner = normal([&](std::size_t k) { return depth.lining[triangle[k]].position; });
    EXPECT_GT(outer.z, -1e-9);
    EXPECT_GT(dot(outer, inner), 0);
  }
}

TEST(WallDepth, AWallAroundASmallHoleIsDrawnThinThereAndWholeAwayFromIt) {
  // A ring of radius 8 around a hole of radius 0.1, 1 thick.
  std::vector<Float3> positions;
  std::vector<Triangle> triangles;
  const double radii[] = {0.1, 0.5, 2, 8};
  for (std::uint32_t ring = 0; ring < 4; ++ring) {
    for (std::uint32_t k = 0; k < 12; ++k) {
      const double angle = k * 0.5235987755982988, r = radii[ring];
      positions.push_back({static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)), 0});
      if (ring == 3) continue;
      const std::uint32_t a = 12 * ring + k, b = 12 * ring + (k + 1) % 12;
      triangles.push_back({a, a + 12, b + 12});
      triangles.push_back({a, b + 12, b});
    }
  }
  SnapshotSurface ring = test::surface_of("ring", positions, triangles);
  auto topology = std::make_shared<SnapshotTopology>(*ring.topology);
  topology->thickness.assign(triangles.size(), 1.0f);
  ring.topology = topology;
  const WallDepth depth = depth_of(ring);
  EXPECT_NEAR(depth.lining[0].position[2], -0.05 * std::pow(24 * 0.1 * std::sin(0.2617993877991494), 2), 1e-6);
  EXPECT_NEAR(depth.lining[12].position[2], depth.lining[0].position[2] - 0.4f, 1e-6);
  EXPECT_FLOAT_EQ(depth.lining[24].position[2], -1);
  EXPECT_FLOAT_EQ(depth.lining[36].position[2], -1);
}

TEST(WallDepth, ARoundBorderHasASmoothRim) {
  // A fan of 24 triangles: borders meet at 15 degrees.
  std::vector<Float3> positions = {{0, 0, 0}};
  std::vector<Triangle> triangles;
  for (std::uint32_t k = 0; k < 24; ++k) {
    const double angle = k * 0.26179938779914943;
    positions.push_back({static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0});
    triangles.push_back({0, 1 + k, 1 + (k + 1) % 24});
  }
  SnapshotSurface disc = test::surface_of("disc", positions, triangles);
  auto topology = std::make_shared<SnapshotTopology>(*disc.topology);
  topology->thickness.assign(24, 0.1f);
  disc.topology = topology;
  for (const SurfaceVertex& vertex : depth_of(disc).rim) {
    EXPECT_NEAR(vertex.normal[0], vertex.position[0], 1e-6);
    EXPECT_NEAR(vertex.normal[1], vertex.position[1], 1e-6);
  }
}

TEST(WallDepth, AWallWithoutABorderShowsNone) {
  SnapshotSurface sphere = test::sphere("organ", {}, 1, 2);
  auto topology = std::make_shared<SnapshotTopology>(*sphere.topology);
  topology->thickness.assign(topology->triangles.size(), 0.1f);
  sphere.topology = topology;
  EXPECT_TRUE(depth_of(sphere).lining.empty());
  EXPECT_TRUE(depth_of(sphere).rim.empty());
}

/// Distances from the middle of the inner side of a ball of a radius of 30 mm, least and most, metres.
std::array<double, 2> radii_within_ball(float thickness) {
  SnapshotSurface ball = test::sphere("organ", {0, 0, 0}, 0.03, 4);
  auto topology = std::make_shared<SnapshotTopology>(*ball.topology);
  topology->thickness.assign(topology->triangles.size(), thickness);
  ball.topology = topology;
  std::array<double, 2> radii{1, 0};
  for (const SurfaceVertex& vertex : inner_side(ball, wall_vertices(ball))) {
    const double radius = length(vector3(vertex.position));
    EXPECT_LT(dot(vector3(vertex.normal), vector3(vertex.position)), -0.99 * radius);
    radii = {std::min(radii[0], radius), std::max(radii[1], radius)};
  }
  return radii;
}

TEST(WallDepth, AWholeWallHasItsInnerSideBehindItButNotBeyondHalfOfItsBend) {
  const auto [least, most] = radii_within_ball(0.002F);
  EXPECT_NEAR(least, 0.028, 1e-5);
  EXPECT_NEAR(most, 0.028, 1e-5);
  const auto [thick_least, thick_most] = radii_within_ball(0.05F);
  // The bend of a wall of triangles is that of the ball within some percent.
  EXPECT_NEAR(thick_least, 0.015, 0.001);
  EXPECT_NEAR(thick_most, 0.015, 0.001);
}

}  // namespace
}  // namespace thinwall
