#include "studio/organs/HoleFilling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "engine/mesh/Shapes.hpp"

namespace thinwall {
namespace {

RawSurface ball(int triangles) {
  const SurfaceMesh mesh = make_sphere(1, triangles);
  return {mesh.vertices, mesh.triangles, std::vector<int>(mesh.triangles.size(), 3)};
}

/// Removes the triangles whose middles lie nearer than `radius` to a place.
void pierce(RawSurface& surface, const Eigen::Vector3d& place, double radius) {
  std::vector<bool> keep;
  for (const Eigen::Vector3i& t : surface.triangles) {
    const Eigen::Vector3d middle = (surface.vertices[t[0]] + surface.vertices[t[1]] + surface.vertices[t[2]]) / 3;
    keep.push_back((middle - place).norm() > radius);
  }
  keep_marked(surface, keep);
}

TEST(HoleFilling, SmallHolesOfABallAreFilledAndItsVolumeIsBackNearly) {
  std::mt19937 random(20260101);
  for (int trial = 0; trial < 50; ++trial) {
    RawSurface surface = ball(5120);
    const double volume = enclosed_volume(surface.vertices, surface.triangles);
    const auto coordinate = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
    for (int hole = 0; hole < 3; ++hole) {
      const Eigen::Vector3d place = Eigen::Vector3d(coordinate(), coordinate(), coordinate() + 0.01).normalized();
      pierce(surface, place, 0.05 + 0.02 * hole);
    }
    remove_unused_vertices(surface);
    if (!is_oriented_manifold(topology_of_surface(surface))) continue;  // two holes that touch in a vertex
    for (const FoundHole& hole : fill_small_holes(surface, 0)) EXPECT_TRUE(hole.filled) << trial;
    EXPECT_TRUE(is_closed(topology_of_surface(surface))) << trial;
    // A cap over a hole of radius 0.1 or less lacks under pi/4 0.1^4 of the volume; three of them.
    EXPECT_NEAR(enclosed_volume(surface.vertices, surface.triangles), volume, 3e-4) << trial;
  }
}

TEST(HoleFilling, WideHoleIsToldAndStays) {
  RawSurface surface = ball(1280);
  pierce(surface, {0, 0, 1}, 0.4);
  remove_unused_vertices(surface);
  const std::size_t before = surface.triangles.size();
  const std::vector<FoundHole> holes = fill_small_holes(surface, 0);
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_FALSE(holes[0].filled);
  EXPECT_NEAR(holes[0].width, 0.8, 0.1);
  EXPECT_NEAR(holes[0].middle[2], std::sqrt(1 - 0.4 * 0.4), 0.05);
  EXPECT_EQ(surface.triangles.size(), before);
}

TEST(HoleFilling, FillingIsOfThePartAroundIt) {
  RawSurface surface = ball(5120);
  pierce(surface, {0, 0, 1}, 0.1);
  remove_unused_vertices(surface);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    surface.parts[t] = surface.vertices[surface.triangles[t][0]][2] > 0 ? 7 : 1;
  }
  const std::size_t before = surface.triangles.size();
  fill_small_holes(surface, 0);
  ASSERT_GT(surface.triangles.size(), before);
  for (std::size_t t = before; t < surface.parts.size(); ++t) EXPECT_EQ(surface.parts[t], 7);
}

TEST(HoleFilling, LongCrackIsFilledHoweverLong) {
  // A tetrahedron whose edge from 1 to 2 has a vertex in the middle on one side only.
  RawSurface surface{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0}},
                     {{0, 2, 4}, {0, 4, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                     {0, 0, 0, 0, 0}};
  const std::vector<FoundHole> holes = fill_small_holes(surface, 1e-6);
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_TRUE(holes[0].filled);
  EXPECT_NEAR(holes[0].width, std::sqrt(2), 1e-15);
  EXPECT_TRUE(is_closed(topology_of_surface(surface)));
}

TEST(HoleFilling, PlanarHoleIsFilledFlat) {
  // A plate of 11 x 11 squares without the middle one, in which the fill lies whatever its diagonal.
  RawSurface plate;
  for (int j = 0; j <= 11; ++j) {
    for (int i = 0; i <= 11; ++i) plate.vertices.emplace_back(i, j, 0);
  }
  for (int j = 0; j < 11; ++j) {
    for (int i = 0; i < 11; ++i) {
      if (i == 5 && j == 5) continue;
      const int a = 12 * j + i;
      plate.triangles.emplace_back(a, a + 1, a + 13);
      plate.triangles.emplace_back(a, a + 13, a + 12);
    }
  }
  plate.parts.assign(plate.triangles.size(), 0);
  fill_small_holes(plate, 0);
  double area = 0;
  for (const double part : triangle_areas(plate.vertices, plate.triangles)) area += part;
  EXPECT_NEAR(area, 121, 1e-12);
  // The rim of the plate is a hole too wide to fill.
  EXPECT_EQ(topology_of_surface(plate).boundary_loops.size(), 1u);
  EXPECT_TRUE(is_oriented_manifold(topology_of_surface(plate)));
}

}  // namespace
}  // namespace thinwall
