#include "renderer/wound/FluidSurface.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

/// A ball of radius 1 that is open above the height 0.5, with as much air in it as told.
struct Scene {
  explicit Scene(double air) {
    const SnapshotSurface ball = test::sphere("bowl", {0, 0, 0}, 1, 4);
    std::vector<Triangle> kept;
    for (const Triangle& triangle : ball.topology->triangles) {
      bool below = false;
      for (const std::uint32_t vertex : triangle) below = below || ball.positions[vertex][2] < 0.5f;
      if (below) kept.push_back(triangle);
    }
    const SnapshotSurface bowl = test::surface_of("bowl", ball.positions, kept);
    snapshot.surfaces = {bowl};
    holes = find_wall_holes(bowl.positions, border_edges(*bowl.topology));
    for (const Float3& position : bowl.positions) normals.push_back(vector3(position));
    thickness.assign(normals.size(), 0.1);
    std::vector<Triangle> closed = bowl.topology->triangles;
    for (const WallHole& hole : holes) closed.insert(closed.end(), hole.lid.begin(), hole.lid.end());
    const double volume = volume_below(bowl.positions, closed, {0, 0, 1}, 10);
    snapshot.scalars = {{"bowl.volume", "m^3", volume}, {"bowl.fluid_volume", "m^3", volume - air}};
  }
  FluidSurface fluid() const { return fluid_surface(snapshot, snapshot.surfaces[0], holes, normals, thickness); }

  Snapshot snapshot;
  std::vector<WallHole> holes;
  std::vector<Vector3> normals;
  std::vector<double> thickness;
};

TEST(FluidSurface, StandsInTheHoleOfAFullBody) {
  const FluidSurface fluid = Scene(0).fluid();
  EXPECT_TRUE(fluid.level.empty());
  ASSERT_FALSE(fluid.lid.empty());
  for (const FluidVertex& vertex : fluid.lid) {
    EXPECT_GT(vertex.normal[2], 0.9F);
    EXPECT_NEAR(vertex.position[2], 0.5, 0.15) << "the border is ragged by a triangle's size";
  }
}

TEST(FluidSurface, IsAPlaneBelowTheHoleWhereThereIsAir) {
  const FluidSurface fluid = Scene(1.5).fluid();
  EXPECT_TRUE(fluid.lid.empty());
  ASSERT_FALSE(fluid.level.empty());
  for (const FluidVertex& vertex : fluid.level) EXPECT_EQ(vertex.position[2], fluid.level[0].position[2]);
  EXPECT_LT(fluid.level[0].position[2], 0.4F);
}

TEST(FluidSurface, TurnsWithGravity) {
  Scene scene(1.5);
  scene.snapshot.gravity = {9.81, 0, 0};
  const FluidSurface fluid = scene.fluid();
  ASSERT_FALSE(fluid.level.empty());
  for (const FluidVertex& vertex : fluid.level) EXPECT_NEAR(vertex.position[0], fluid.level[0].position[0], 1e-6);
  EXPECT_FALSE(fluid.lid.empty()) << "it stands in the lower part of the hole";
}

TEST(FluidSurface, IsNotSeenInAClosedBodyNorWithoutWordOfIt) {
  Scene closed(0);
  closed.holes.clear();
  EXPECT_TRUE(closed.fluid().lid.empty());
  Scene silent(0);
  silent.snapshot.scalars.clear();
  EXPECT_TRUE(silent.fluid().lid.empty());
}

}  // namespace
}  // namespace thinwall
