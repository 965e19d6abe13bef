#include "engine/mesh/Region.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "engine/mesh/Shapes.hpp"

namespace thinwall {
namespace {

/// A unit square of two triangles in z = 0 with a third one standing on its right edge.
SurfaceMesh square_with_flap() {
  SurfaceMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0.5, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}};
  mesh.groups = {{"flap", {1, 2, 4}}, {"wall", {0, 1, 2, 3, 4}}};
  return mesh;
}

using Indices = std::vector<int>;

TEST(Region, GroupHoldsItsVerticesAndTheTrianglesThatLieInItWhole) {
  EXPECT_EQ(vertices_in(GroupRegion{"flap"}, square_with_flap()), (Indices{1, 2, 4}));
  EXPECT_EQ(triangles_in(GroupRegion{"flap"}, square_with_flap()), (Indices{2}));
}

TEST(Region, MissingGroupIsOutOfRange) {
  EXPECT_THROW(vertices_in(GroupRegion{"base"}, square_with_flap()), std::out_of_range);
  EXPECT_THROW(triangles_in(GroupRegion{"base"}, square_with_flap()), std::out_of_range);
}

TEST(Region, PlaneHoldsWhatLiesWithinItsReachLimitsIncluded) {
  EXPECT_EQ(vertices_in(PlaneRegion{0, 1, 1e-9}, square_with_flap()), (Indices{1, 2, 4}));
  EXPECT_EQ(vertices_in(PlaneRegion{2, 0.5, 0.5}, square_with_flap()), (Indices{0, 1, 2, 3, 4}));
  EXPECT_EQ(triangles_in(PlaneRegion{0, 1, 1e-9}, square_with_flap()), (Indices{2}));
}

TEST(Region, BelowAndAboveShareTheirLimit) {
  EXPECT_EQ(vertices_in(BelowRegion{1, 0.5}, square_with_flap()), (Indices{0, 1, 4}));
  EXPECT_EQ(vertices_in(AboveRegion{1, 0.5}, square_with_flap()), (Indices{2, 3, 4}));
}

TEST(Region, TrianglesGoByTheirCentroid) {
  EXPECT_EQ(triangles_in(BelowRegion{1, 0.34}, square_with_flap()), (Indices{0}));
  EXPECT_EQ(triangles_in(AboveRegion{2, 0.3}, square_with_flap()), (Indices{2}));
}

TEST(Region, BoxAndSphereIncludeTheirSurface) {
  EXPECT_EQ(vertices_in(BoxRegion{{0, 0, 0}, {1, 0.5, 1}}, square_with_flap()), (Indices{0, 1, 4}));
  EXPECT_EQ(vertices_in(SphereRegion{{0, 0, 0}, 1}, square_with_flap()), (Indices{0, 1, 3}));
}

/// The base of a hemisphere is level with y = 0 once it is turned, but for what turning rounds.
TEST(Region, LimitsHoldWhatATurnRoundsPastThem) {
  SurfaceMesh mesh = make_hemisphere(0.02, 320);
  const Indices base = vertices_in(BelowRegion{2, 0}, mesh);
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX()) * vertex;
  EXPECT_EQ(base.size(), mesh.groups.at("base").size());
  EXPECT_EQ(vertices_in(AboveRegion{1, 0}, mesh), base);
  EXPECT_EQ(vertices_in(PlaneRegion{1, 0, 0}, mesh), base);
  EXPECT_EQ(vertices_in(BoxRegion{{-1, 0, -1}, {1, 1, 1}}, mesh), base);
}

/// 0.05 - 0.02 is more than 0.03 where numbers are binary.
TEST(Region, LimitsHoldWhatASumRoundsPastThem) {
  SurfaceMesh mesh = square_with_flap();
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex = Eigen::Vector3d(0.05, 0, 0) + 0.02 * (vertex.array() - 1).matrix();
  ASSERT_GT(mesh.vertices[0].x(), 0.03);
  EXPECT_EQ(vertices_in(BelowRegion{0, 0.03}, mesh), (Indices{0, 3}));
  EXPECT_EQ(vertices_in(SphereRegion{{0.02, -0.02, -0.02}, 0.01}, mesh), (Indices{0}));
}

TEST(Region, AllHoldsEveryVertexAndTriangle) {
  EXPECT_EQ(vertices_in(WholeRegion{}, square_with_flap()), (Indices{0, 1, 2, 3, 4}));
  EXPECT_EQ(triangles_in(WholeRegion{}, square_with_flap()), (Indices{0, 1, 2}));
}

TEST(Region, BoundaryIsTheOpenEdgesOfTheWallCappedOrNot) {
  SurfaceMesh mesh = square_with_flap();
  EXPECT_EQ(vertices_in(BoundaryRegion{}, mesh), (Indices{0, 1, 2, 3, 4}));
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  EXPECT_EQ(vertices_in(BoundaryRegion{}, mesh), (Indices{0, 1, 2, 3}));
  mesh.cap_triangles = {{0, 3, 2}, {0, 2, 1}};
  EXPECT_EQ(vertices_in(BoundaryRegion{}, mesh), (Indices{0, 1, 2, 3}));
  EXPECT_TRUE(triangles_in(BoundaryRegion{}, mesh).empty());
}

}  // namespace
}  // namespace thinwall
