#include "engine/cutting/SurfacePath.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/cutting/CurveChecks.hpp"
#include "tests/engine/cutting/SlitMeshes.hpp"
#include "tests/engine/tool/TestSurface.hpp"

namespace thinwall {
namespace {

TEST(SurfacePath, PointsGoToTheNearestPointOfTheSurface) {
  const TestSurface sphere(make_sphere(0.02, 1280));
  const SurfaceProjection found = project(sphere.view(), {0.003, 0.004, 0.025}, {}, 0.01);
  ASSERT_TRUE(found.point);
  EXPECT_NEAR(found.distance, std::hypot(0.005, 0.025) - 0.02, 2e-4) << "the facets lie within the sphere";
  EXPECT_GE(found.distance, std::hypot(0.005, 0.025) - 0.02);
  const Eigen::Vector3d position = position_of(sphere.view(), *found.point);
  EXPECT_LT((position.normalized() - Eigen::Vector3d(0.003, 0.004, 0.025).normalized()).norm(), 0.03);
}

TEST(SurfacePath, PointsGoAlongTheDirectionToTheSideThatFacesIt) {
  const TestSurface cube(unit_cube());
  for (const double height : {1.4, 0.9, 0.1}) {
    const SurfaceProjection found = project(cube.view(), {0.3, 0.6, height}, kDown, 1);
    ASSERT_TRUE(found.point);
    EXPECT_LT((position_of(cube.view(), *found.point) - Eigen::Vector3d(0.3, 0.6, 1)).norm(), 1e-15);
    EXPECT_NEAR(found.distance, std::abs(1 - height), 1e-15);
  }
  EXPECT_TRUE(std::isinf(project(cube.view(), {1.3, 0.6, 2}, kDown, 1).distance));
}

TEST(SurfacePath, BeyondTheReachThereIsNoPointButTheDistance) {
  const TestSurface sheet(make_sheet(0.04, 0.04, 100), true);
  const SurfaceProjection found = project(sheet.view(), {0, 0, 0.011}, {}, 0.01);
  EXPECT_FALSE(found.point);
  EXPECT_NEAR(found.distance, 0.011, 1e-16);
}

TEST(SurfacePath, RunsThroughAllItsPointsInOnePiece) {
  const TestSurface sheet(make_sheet(0.04, 0.04, 400), true);
  const std::vector<Eigen::Vector3d> points = {
      {-0.01, -0.01, 0.002}, {0.01, -0.01, -0.003}, {0.01, 0.005, 0}, {0.01, 0.005, 0.001}, {0, 0.005, 0}};
  const PathResult result = surface_path(sheet.view(), points, {}, 0.01);
  ASSERT_FALSE(result.problem);
  ASSERT_EQ(result.path.pieces.size(), 1U);
  expect_connected(sheet.view(), result.path.pieces[0], 1e-14);
  EXPECT_NEAR(result.path.length(), 0.02 + 0.015 + 0.01, 1e-15);
  EXPECT_LT((result.path.at(0.02 + 0.007).position - Eigen::Vector3d(0.01, -0.003, 0)).norm(), 1e-15);
  EXPECT_LT((result.path.at(-1).position - Eigen::Vector3d(-0.01, -0.01, 0)).norm(), 1e-15);
  EXPECT_LT((result.path.at(1).position - Eigen::Vector3d(0, 0.005, 0)).norm(), 1e-15);
  EXPECT_LT((result.path.at(0.013).inward - kDown).norm(), 1e-15);
}

TEST(SurfacePath, InwardNormalsTurnEvenlyOnASphere) {
  const TestSurface sphere(make_sphere(0.02, 5120));
  const std::vector<Eigen::Vector3d> points = {{0.002, 0.001, 0.021}, {0.019, 0.004, 0.006}};
  const PathResult result = surface_path(sphere.view(), points, {}, 0.01);
  ASSERT_FALSE(result.problem);
  for (int k = 0; k <= 100; ++k) {
    const PathStation station = result.path.at(0.01 * k * result.path.length());
    // A facet leans by up to 0.03 rad from the sphere; the interpolated normals by far less.
    EXPECT_LT((station.inward + station.position.normalized()).norm(), 2e-3);
    EXPECT_NEAR(station.inward.norm(), 1, 1e-14);
  }
}

TEST(SurfacePath, OnAnOpenSurfaceTheDirectionTellsTheInnerSide) {
  const TestSurface sheet(make_sheet(0.04, 0.04, 400), true);
  const std::vector<Eigen::Vector3d> points = {{-0.01, 0, 0}, {0.01, 0, 0}};
  const PathResult below = surface_path(sheet.view(), points, Eigen::Vector3d(0, 0, 1), 0.01);
  EXPECT_LT((below.path.at(0).inward + kDown).norm(), 1e-15);
  const PathResult above = surface_path(sheet.view(), points, kDown, 0.01);
  EXPECT_LT((above.path.at(0).inward - kDown).norm(), 1e-15);
}

TEST(SurfacePath, OverAWoundHasTwoPiecesAndAStraightGap) {
  const double gape = 3e-3;
  const TestSurface sheet(slit_sheet(gape), true);
  const std::vector<Eigen::Vector3d> points = {{-0.01, 0, 0}, {0.01, 0, 0}, {0.01, 0.01, 0}};
  const PathResult result = surface_path(sheet.view(), points, {}, 0.01);
  ASSERT_FALSE(result.problem);
  EXPECT_EQ(result.path.pieces.size(), 2U);
  EXPECT_NEAR(result.path.length(), 0.03, 1e-14);
  EXPECT_LT((result.path.at(0.01).position).norm(), 1e-14);
}

TEST(SurfacePath, TellsWhichPointIsTooFarAndWhichTwoAreNotJoined) {
  const TestSurface sphere(make_sphere(0.02, 320));
  const std::vector<Eigen::Vector3d> far = {{0, 0, 0.02}, {0.02, 0, 0.001}, {0.05, 0, 0}};
  const PathResult off = surface_path(sphere.view(), far, {}, 0.01);
  ASSERT_TRUE(off.problem);
  EXPECT_EQ(off.problem->kind, PathProblem::Kind::kOffSurface);
  EXPECT_EQ(off.problem->point, 2);
  EXPECT_NEAR(off.problem->distance, 0.03, 1e-3);
  const std::vector<Eigen::Vector3d> poles = {{0.02, 0, 0.001}, {0, 0, 0.02}, {0, 0, -0.02}};
  const PathResult through = surface_path(sphere.view(), poles, {}, 0.01);
  ASSERT_TRUE(through.problem);
  EXPECT_EQ(through.problem->kind, PathProblem::Kind::kAlongNormal);
  EXPECT_EQ(through.problem->point, 2);
}

}  // namespace
}  // namespace thinwall
