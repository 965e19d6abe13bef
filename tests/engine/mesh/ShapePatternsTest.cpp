#include "engine/mesh/ShapePatterns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

TEST(ShapePatterns, FilledPolygonIsADiscWithTheSenseAndRimOfThePolygon) {
  for (int corners = 3; corners < 40; ++corners) {
    std::vector<int> polygon(corners);
    std::iota(polygon.begin(), polygon.end(), 0);
    const std::vector<Eigen::Vector3i> filling = fill_polygon(polygon);
    const MeshTopology topology = topology_of(corners, filling);
    ASSERT_EQ(static_cast<int>(filling.size()), corners - 2);
    ASSERT_TRUE(is_oriented_manifold(topology)) << corners;
    ASSERT_EQ(topology.boundary_loops, (std::vector<std::vector<int>>{polygon})) << corners;
  }
}

TEST(ShapePatterns, ClosestSquareTakesTheNearestCount) {
  EXPECT_EQ(closest_square(5120, 20), 16);
  EXPECT_EQ(closest_square(1, 20), 1);
  EXPECT_EQ(closest_square(49, 20), 1);  // 20 is nearer than 80
  EXPECT_EQ(closest_square(51, 20), 2);
}

TEST(ShapePatterns, ClosestDivisionFindsTheExactCountOfEquilateralTriangles) {
  const Division division = closest_division(
      200, 2, 2, 1, [](Division d) { return 2 * d.across * d.along; },
      [](Division d) { return static_cast<double>(d.along) / d.across; });
  EXPECT_EQ(division.across, 10);
  EXPECT_EQ(division.along, 10);
}

TEST(ShapePatterns, EveryPatternIsAnOrientedManifold) {
  for (const Pattern& pattern : {staggered_rows(6, 5, false), staggered_rows(6, 5, true), centred_rings(6, 4),
                                 centred_rings(4, 1), staggered_circles(3, 7), staggered_circles(4, 8)}) {
    const MeshTopology topology = topology_of(static_cast<int>(pattern.coordinates.size()), pattern.triangles);
    EXPECT_TRUE(is_oriented_manifold(topology));
    EXPECT_EQ(topology.component_count, 1);
  }
}

}  // namespace
}  // namespace thinwall
