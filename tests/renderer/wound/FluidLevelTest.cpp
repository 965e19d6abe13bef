#include "renderer/wound/FluidLevel.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Vector3 kUp{0, 0, 1};

/// A cube of 2 with its middle at the origin.
SnapshotSurface cube() {
  std::vector<Float3> corners;
  for (const float z : {-1.0f, 1.0f}) corners.insert(corners.end(), {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}});
  return test::surface_of("cube", corners,
                          {{0, 2, 1},
                           {0, 3, 2},
                           {4, 5, 6},
                           {4, 6, 7},
                           {0, 1, 5},
                           {0, 5, 4},
                           {1, 2, 6},
                           {1, 6, 5},
                           {2, 3, 7},
                           {2, 7, 6},
                           {3, 0, 4},
                           {3, 4, 7}});
}

double volume_of(const SnapshotSurface& surface) {
  return volume_below(surface.positions, surface.topology->triangles, kUp, 1e3);
}

TEST(FluidLevel, BelowALevelLiesThatPartOfACube) {
  const SnapshotSurface box = cube();
  for (const double level : {-1.0, -0.4, 0.0, 0.7, 1.0}) {
    EXPECT_NEAR(volume_below(box.positions, box.topology->triangles, kUp, level), 4 * (level + 1), 1e-12) << level;
  }
  EXPECT_NEAR(volume_of(box), 8, 1e-12);
}

TEST(FluidLevel, OfAHalfFullSphereGoesThroughItsMiddleWhateverIsUp) {
  const SnapshotSurface ball = test::sphere("ball", {0.01, -0.02, 0.03}, 0.02, 3);
  for (const Vector3 up : {kUp, Vector3{1, 0, 0}, normalized({0.3, -0.5, 0.6})}) {
    const double level = fluid_level(ball.positions, ball.topology->triangles, up, 0.5 * volume_of(ball));
    // Positions are floats: of 0.05 to 3e-9.
    EXPECT_NEAR(level, dot(up, {0.01, -0.02, 0.03}), 1e-8);
  }
}

TEST(FluidLevel, OfASphereIsWhereTheCapHasTheVolumeOfTheAir) {
  const SnapshotSurface ball = test::sphere("ball", {0, 0, 0}, 1, 5);
  for (const double depth : {0.1, 0.5, 1.0, 1.6}) {
    const double cap = kPi * depth * depth * (1 - depth / 3);  // under depth from the crown
    const double level = fluid_level(ball.positions, ball.topology->triangles, kUp, cap);
    // Triangles of a twentieth of the radius cut off e^2/8 of it, 4e-4; all of it counts at the level, a small circle.
    EXPECT_NEAR(level, 1 - depth, 4e-3) << depth;
  }
}

TEST(FluidLevel, IsAtTheBrimWithoutAirAndAtTheBottomWithoutFluid) {
  const SnapshotSurface box = cube();
  EXPECT_EQ(fluid_level(box.positions, box.topology->triangles, kUp, 0), kBrimful);
  EXPECT_EQ(fluid_level(box.positions, box.topology->triangles, kUp, 9), -1);
}

TEST(FluidLevel, ContourSurroundsTheSection) {
  const SnapshotSurface box = cube();
  const std::vector<Vector3> contour = level_contour(box.positions, box.topology->triangles, kUp, 0.25);
  double area = 0;
  for (std::size_t k = 0; k + 1 < contour.size(); k += 2) {
    EXPECT_NEAR(contour[k].z, 0.25, 1e-12);
    area += 0.5 * dot(cross(contour[k], contour[k + 1]), kUp);
  }
  EXPECT_NEAR(area, 4, 1e-12) << "counter-clockwise, so the inside is on the left";
}

TEST(FluidLevel, FluidRunsWithGravityAndDownThePictureWithoutIt) {
  Snapshot snapshot;
  EXPECT_EQ(downward(snapshot).z, -1);
  snapshot.gravity = {0, -9.81, 0};
  EXPECT_EQ(downward(snapshot).y, -1);
}

}  // namespace
}  // namespace thinwall
