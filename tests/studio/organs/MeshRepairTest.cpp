#include "studio/organs/MeshRepair.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

RawSurface tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, {0, 0, 0, 0}};
}

bool is_closed_surface(const RawSurface& surface) {
  return is_closed(topology_of(static_cast<int>(surface.vertices.size()), surface.triangles));
}

/// Every triangle with vertices of its own, as in an STL file.
RawSurface soup_of(const RawSurface& surface) {
  RawSurface soup;
  soup.parts = surface.parts;
  for (const Eigen::Vector3i& t : surface.triangles) {
    const int first = static_cast<int>(soup.vertices.size());
    for (const int v : t) soup.vertices.push_back(surface.vertices[v]);
    soup.triangles.emplace_back(first, first + 1, first + 2);
  }
  return soup;
}

TEST(MeshRepair, WeldingASoupClosesIt) {
  RawSurface soup = soup_of(tetrahedron());
  EXPECT_FALSE(is_closed_surface(soup));
  EXPECT_EQ(weld_vertices(soup, 1e-6), 0);
  EXPECT_EQ(remove_unused_vertices(soup), 8);
  EXPECT_TRUE(is_closed_surface(soup));
}

TEST(MeshRepair, WeldingReachesAsFarAsTheToleranceAndCountsWhatMoved) {
  RawSurface soup = soup_of(tetrahedron());
  soup.vertices[3] += Eigen::Vector3d(0.9e-6, 0, 0);
  EXPECT_EQ(weld_vertices(soup, 1e-6), 1);
  EXPECT_EQ(soup.triangles[1][0], 0);
  RawSurface apart = soup_of(tetrahedron());
  apart.vertices[3] += Eigen::Vector3d(1.1e-6, 0, 0);
  EXPECT_EQ(weld_vertices(apart, 1e-6), 0);
  EXPECT_EQ(apart.triangles[1][0], 3);
}

TEST(MeshRepair, WeldingFindsNeighboursAcrossTheCellsOfItsGrid) {
  for (int i = -40; i <= 40; ++i) {
    const double x = i * 0.37e-6;
    RawSurface pair{{{x, x, x}, {x + 0.5e-6, x - 0.5e-6, x + 0.5e-6}}, {}, {}};
    EXPECT_EQ(weld_vertices(pair, 1e-6), 1) << i;
  }
}

TEST(MeshRepair, CollapsedAndRepeatedTrianglesAreRemoved) {
  RawSurface surface = tetrahedron();
  surface.triangles.insert(surface.triangles.begin(), {{0, 0, 1}, {2, 3, 1}});
  surface.parts.insert(surface.parts.begin(), {0, 0});
  EXPECT_EQ(remove_collapsed_triangles(surface), 1);
  EXPECT_EQ(remove_repeated_triangles(surface), 1);
  EXPECT_EQ(surface.triangles.size(), 4u);
}

TEST(MeshRepair, FlatTriangleIsTurnedAwayWithoutTearingAGap) {
  // The edge from 1 to 2 is cut by vertex 4 on one side only; a flat triangle closes the crack.
  RawSurface surface = tetrahedron();
  surface.vertices.push_back({0.5, 0.5, 0});
  surface.triangles = {{0, 2, 4}, {0, 4, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {4, 2, 1}};
  surface.parts.assign(6, 0);
  ASSERT_TRUE(is_closed_surface(surface));
  EXPECT_EQ(remove_flat_triangles(surface, 1e-6), 1);
  EXPECT_TRUE(is_closed_surface(surface));
  for (const double angle : smallest_angles(surface.vertices, surface.triangles)) EXPECT_GT(angle, 0.1);
  EXPECT_NEAR(enclosed_volume(surface.vertices, surface.triangles), 1.0 / 6, 1e-15);
}

TEST(MeshRepair, RowOfFlatTrianglesIsTurnedAwayToo) {
  RawSurface surface = tetrahedron();
  surface.vertices.insert(surface.vertices.end(), {{0.75, 0.25, 0}, {0.5, 0.5, 0}, {0.25, 0.75, 0}});
  surface.triangles = {{0, 4, 1}, {0, 5, 4}, {0, 6, 5}, {0, 2, 6}, {1, 4, 2},
                       {4, 5, 2}, {5, 6, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  surface.parts.assign(10, 0);
  ASSERT_TRUE(is_closed_surface(surface));
  EXPECT_GE(remove_flat_triangles(surface, 1e-6), 3);
  EXPECT_TRUE(is_closed_surface(surface));
  for (const double angle : smallest_angles(surface.vertices, surface.triangles)) EXPECT_GT(angle, 0.1);
}

TEST(MeshRepair, TurnedTrianglesAreTurnedBack) {
  RawSurface surface = tetrahedron();
  std::swap(surface.triangles[2][0], surface.triangles[2][1]);
  const OrientationResult result = orient_outwards(surface);
  EXPECT_TRUE(result.orientable);
  EXPECT_EQ(result.turned, 1);
  EXPECT_EQ(result.turned_inside, 0);
  EXPECT_TRUE(is_closed_surface(surface));
}

TEST(MeshRepair, SurfaceThatFacesInwardsIsTurnedOutwards) {
  RawSurface surface = tetrahedron();
  for (Eigen::Vector3i& t : surface.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(orient_outwards(surface).turned_inside, 1);
  EXPECT_GT(enclosed_volume(surface.vertices, surface.triangles), 0);
}

TEST(MeshRepair, BowlThatFacesInwardsIsTurnedOutwardsAndAFlatSheetKeepsItsSense) {
  RawSurface bowl = tetrahedron();
  bowl.triangles = {{1, 0, 3}, {2, 1, 3}, {0, 2, 3}};
  bowl.parts.assign(3, 0);
  EXPECT_EQ(orient_outwards(bowl).turned_inside, 1);
  RawSurface sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 2, 1}, {0, 3, 2}}, {0, 0}};
  EXPECT_EQ(orient_outwards(sheet).turned_inside, 0);
  EXPECT_EQ(sheet.triangles[0], Eigen::Vector3i(0, 2, 1));
}

TEST(MeshRepair, ComponentsAreMeasuredAndOneIsKept) {
  RawSurface surface = tetrahedron();
  surface.vertices.insert(surface.vertices.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
  surface.triangles.push_back({4, 5, 6});
  surface.parts.push_back(1);
  const std::vector<SurfaceComponent> components = components_of(surface);
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[0].triangles, 4);
  EXPECT_NEAR(components[1].area, 0.5, 1e-15);
  keep_component(surface, 1);
  EXPECT_EQ(surface.vertices.size(), 3u);
  EXPECT_EQ(surface.parts, (std::vector<int>{1}));
}

}  // namespace
}  // namespace thinwall
