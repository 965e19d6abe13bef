#include "renderer/annotation/MaterialPoint.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

TEST(MaterialPoint, GoesWithTheMaterial) {
  SnapshotSurface sheet = test::quad("sheet", {Float3{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  const auto point = nearest_material_point(*sheet.topology, {1.5, 0.5, 0.3});
  ASSERT_TRUE(point);
  EXPECT_EQ(point->triangle, 0U);
  for (Float3& position : sheet.positions) position = {3 * position[0], position[1], position[0] + 1};
  const Vector3 place = place_of(*point, sheet);
  EXPECT_NEAR(place.x, 4.5, 1e-12);
  EXPECT_NEAR(place.y, 0.5, 1e-12);
  EXPECT_NEAR(place.z, 2.5, 1e-12);
}

TEST(MaterialPoint, OutsideIsTheNearestPointOfTheBorder) {
  const SnapshotSurface sheet = test::quad("sheet", {Float3{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  const auto side = nearest_material_point(*sheet.topology, {1.25, -3, 0});
  EXPECT_NEAR(place_of(*side, sheet).x, 1.25, 1e-12);
  EXPECT_NEAR(place_of(*side, sheet).y, 0, 1e-12);
  const auto corner = nearest_material_point(*sheet.topology, {5, 5, 1});
  EXPECT_NEAR(place_of(*corner, sheet).x, 2, 1e-12);
  EXPECT_NEAR(place_of(*corner, sheet).y, 2, 1e-12);
}

TEST(MaterialPoint, IsFoundAgainAfterACutHasChangedTheTriangles) {
  const SnapshotSurface whole = test::quad("sheet", {Float3{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  // Cut along x = 1: the left half stays, the right one has moved away by 1.
  SnapshotSurface cut = test::surface_of(
      "sheet", {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 0}, {1, 2, 0}, {1, 0, 0}, {1, 2, 0}},
      {{0, 4, 5}, {0, 5, 3}, {6, 1, 2}, {6, 2, 7}});
  for (const std::uint32_t moved : {1U, 2U, 6U, 7U}) cut.positions[moved][0] += 1;
  const Double3 place = {1.5, 0.75, 0};
  EXPECT_NEAR(place_of(*nearest_material_point(*whole.topology, place), whole).x, 1.5, 1e-12);
  const Vector3 after = place_of(*nearest_material_point(*cut.topology, place), cut);
  EXPECT_NEAR(after.x, 2.5, 1e-12);
  EXPECT_NEAR(after.y, 0.75, 1e-12);
}

TEST(MaterialPoint, ThereIsNoneWithoutTriangles) {
  EXPECT_FALSE(nearest_material_point({}, {0, 0, 0}));
}

TEST(MaterialPoint, IsHiddenBehindAWallButNotByItsOwn) {
  Snapshot snapshot;
  snapshot.surfaces.push_back(test::sphere("ball", {0, 0, 0}, 1, 3));
  const SnapshotSurface& ball = snapshot.surfaces.front();
  const auto top = nearest_material_point(*ball.topology, {0.1, 0.2, 2});
  const auto bottom = nearest_material_point(*ball.topology, {0.1, 0.2, -2});
  const Vector3 eye{0, 0, 5};
  EXPECT_FALSE(is_hidden(place_of(*top, ball), eye, snapshot));
  EXPECT_TRUE(is_hidden(place_of(*bottom, ball), eye, snapshot));
}

}  // namespace
}  // namespace thinwall
