#include "renderer/shape/SurfaceVertices.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

TEST(WallVertices, NormalsOfASphereArePointersFromItsCentre) {
  const SnapshotSurface sphere = test::sphere("organ", {}, 1, 4);
  for (const SurfaceVertex& vertex : wall_vertices(sphere)) {
    // Angle weights err by less than the square of the edge length, here 0.1.
    EXPECT_GT(dot(vector3(vertex.normal), vector3(vertex.position)), 1 - 1e-4);
  }
}

TEST(WallVertices, NormalsFollowThePositionsOfTheMoment) {
  SnapshotSurface square = test::quad("sheet", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  for (Float3& position : square.positions) position = {position[0], 0, position[1]};
  for (const SurfaceVertex& vertex : wall_vertices(square)) {
    EXPECT_NEAR(vertex.normal[1], -1, 1e-6);
    EXPECT_EQ(vertex.rest[2], 0);
  }
}

TEST(WallVertices, TheCurvatureOfASphereIsThatOfItsRadiusWhateverTheTriangles) {
  for (const int divisions : {3, 4}) {
    for (const SurfaceVertex& vertex : wall_vertices(test::sphere("organ", {}, 0.02, divisions))) {
      // The mean edge length differs by 15 % from corner to corner.
      EXPECT_NEAR(vertex.curvature, -50, 4);
    }
  }
}

TEST(WallVertices, ADentCurvesTheOtherWay) {
  SnapshotSurface sphere = test::sphere("organ", {}, 1, 3);
  sphere.positions[4] = {0, 0, 0.7f};
  EXPECT_GT(wall_vertices(sphere)[4].curvature, 1);
}

TEST(WallVertices, AStretchedWallIsThinner) {
  SnapshotSurface square = test::quad("sheet", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  for (const SurfaceVertex& vertex : wall_vertices(square)) EXPECT_NEAR(vertex.thickness, 1, 1e-6);
  for (Float3& position : square.positions) position[0] *= 2;
  for (const SurfaceVertex& vertex : wall_vertices(square)) EXPECT_NEAR(vertex.thickness, 0.5, 1e-6);
}

TEST(WallVertices, PressureAndStretchDriveTheBloodOut) {
  SnapshotSurface sphere = test::sphere("organ", {}, 1, 2);
  for (const SurfaceVertex& vertex : wall_vertices(sphere)) EXPECT_EQ(vertex.blanch, 0);

  SnapshotSurface pressed = sphere;
  // Capillary closing pressure: half of the blood.
  pressed.fields.push_back(
      {.name = "contact_pressure", .unit = "Pa", .values = std::vector<float>(pressed.positions.size(), 4300)});
  for (const SurfaceVertex& vertex : wall_vertices(pressed)) EXPECT_NEAR(vertex.blanch, 0.5, 1e-6);

  SnapshotSurface stretched = sphere;
  for (Float3& position : stretched.positions) position = {2 * position[0], 2 * position[1], 2 * position[2]};
  // Four times the area: three quarters of the colour are gone.
  for (const SurfaceVertex& vertex : wall_vertices(stretched)) EXPECT_NEAR(vertex.blanch, 0.75, 1e-6);
}

TEST(CapVertices, AreFlat) {
  auto topology = std::make_shared<SnapshotTopology>();
  topology->rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  topology->cap_triangles = {{0, 2, 1}};
  const SnapshotSurface surface{
      .body = "organ", .topology = topology, .positions = topology->rest_positions, .fields = {}};
  const std::vector<SurfaceVertex> vertices = cap_vertices(surface);
  ASSERT_EQ(vertices.size(), 3u);
  for (const SurfaceVertex& vertex : vertices) EXPECT_EQ(vertex.normal, (Float3{0, 0, -1}));
}

}  // namespace
}  // namespace thinwall
