#include "engine/cutting/PlaneSection.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/cutting/CurveChecks.hpp"
#include "tests/engine/tool/TestSurface.hpp"

namespace thinwall {
namespace {

const Eigen::Vector3d kOrigin = Eigen::Vector3d::Zero();

TEST(PlaneSection, OfASphereIsOneCircle) {
  const TestSurface sphere(make_sphere(0.02, 5120));
  const CuttingPlane plane{.point = {0, 0, 0.0112}, .normal = Eigen::Vector3d(1, -2, 7).normalized()};
  const auto curves = plane_section(sphere.view(), plane, PlaneTies::kInFront);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  expect_connected(sphere.view(), curves[0], 0);
  const double height = plane.normal.dot(plane.point), radius = std::sqrt(0.02 * 0.02 - height * height);
  for (const SurfacePoint& point : curves[0].points) {
    const Eigen::Vector3d position = position_of(sphere.view(), point);
    EXPECT_NEAR(plane.normal.dot(position - plane.point), 0, 1e-12 * 0.02);
    // Points of the mesh lie within the sagitta of its edges (1.6 mm at most) of the sphere.
    EXPECT_NEAR((position - height * plane.normal).norm(), radius, 4e-5);
  }
  EXPECT_NEAR(length_of(sphere.view(), curves[0]), 2 * std::numbers::pi * radius, 1e-3 * 2 * std::numbers::pi * radius);
}

TEST(PlaneSection, ThroughVerticesAndAlongEdgesIsOneCurveEitherWay) {
  // The plane x = 0 holds a row of the sheet's vertices and the edges between them.
  const TestSurface sheet(make_sheet(0.04, 0.04, 400), true);
  const CuttingPlane plane{.point = kOrigin, .normal = Eigen::Vector3d::UnitX()};
  for (const PlaneTies ties : {PlaneTies::kInFront, PlaneTies::kBehind}) {
    const auto curves = plane_section(sheet.view(), plane, ties);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_FALSE(curves[0].closed);
    EXPECT_NEAR(length_of(sheet.view(), curves[0]), 0.04, 1e-15);
    for (const SurfacePoint& point : curves[0].points) EXPECT_EQ(position_of(sheet.view(), point).x(), 0);
  }
}

TEST(PlaneSection, AtTheBorderFollowsItOrMissesIt) {
  const TestSurface sheet(make_sheet(0.04, 0.04, 400), true);
  const CuttingPlane plane{.point = {0.02, 0, 0}, .normal = Eigen::Vector3d::UnitX()};
  const auto along = plane_section(sheet.view(), plane, PlaneTies::kInFront);
  ASSERT_EQ(along.size(), 1U);
  EXPECT_NEAR(length_of(sheet.view(), along[0]), 0.04, 1e-15);
  EXPECT_TRUE(plane_section(sheet.view(), plane, PlaneTies::kBehind).empty());
}

TEST(PlaneSection, PassesByTrianglesThatLieInThePlane) {
  const TestSurface cube(unit_cube());
  const CuttingPlane plane{.point = {0.5, 0.5, 1}, .normal = Eigen::Vector3d::UnitZ()};
  const auto around = plane_section(cube.view(), plane, PlaneTies::kInFront);
  ASSERT_EQ(around.size(), 1U);
  EXPECT_TRUE(around[0].closed);
  EXPECT_NEAR(length_of(cube.view(), around[0]), 4, 1e-15);
  EXPECT_TRUE(plane_section(cube.view(), plane, PlaneTies::kBehind).empty());
}

TEST(PlaneSection, GoesThroughBothWallsOfAFold) {
  // Two sheets over each other, joined along one side: a bag folded flat.
  SurfaceMesh bag = make_sheet(0.02, 0.04, 300);
  for (Eigen::Vector3d& vertex : bag.vertices) {
    const double around = vertex.y() / 0.04 * 2 * std::numbers::pi;
    vertex.y() = std::abs(vertex.y());
    vertex.z() = 5e-4 * std::sin(0.5 * around);
  }
  const TestSurface folded(bag, true);
  const CuttingPlane plane{.point = {0, 0.01, 0}, .normal = Eigen::Vector3d(0.1, 1, 0).normalized()};
  const auto curves = plane_section(folded.view(), plane, PlaneTies::kInFront);
  ASSERT_EQ(curves.size(), 2U);
  for (const SurfaceCurve& curve : curves) {
    EXPECT_NEAR(length_of(folded.view(), curve), 0.02 / plane.normal.y(), 1e-4);
  }
}

/// A mesh whose vertices have been moved about, so that no two planes of it are the same.
SurfaceMesh shaken(SurfaceMesh mesh, double by, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-by, by);
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex += Eigen::Vector3d(uniform(random), uniform(random), uniform(random));
  return mesh;
}

TEST(PlaneSection, RandomPlanesGiveCurvesThatCrossEachCrossedTriangleOnce) {
  int missed = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const bool open = seed % 3 == 0;
    const TestSurface surface(
        shaken(open ? make_cylinder(0.01, 0.05, 600) : make_sphere(0.02, 720), seed % 2 == 0 ? 0.0 : 5e-4, random),
        open);
    // Every second plane passes through three vertices, as those of regular meshes do by themselves.
    const SurfaceView view = surface.view();
    CuttingPlane plane{.normal = Eigen::Vector3d(uniform(random), uniform(random), uniform(random)).normalized()};
    if (seed % 4 < 2) {
      const auto vertex = [&] {
        return view.position.segment<3>(3 * static_cast<Eigen::Index>(random() % (view.position.size() / 3))).eval();
      };
      const Eigen::Vector3d a = vertex(), b = vertex(), c = vertex();
      plane = {.point = a, .normal = (b - a).cross(c - a).normalized()};
    }
    if (!plane.normal.allFinite()) continue;
    for (const PlaneTies ties : {PlaneTies::kInFront, PlaneTies::kBehind}) {
      std::vector<int> seen;
      for (const SurfaceCurve& curve : plane_section(view, plane, ties)) {
        EXPECT_TRUE(curve.closed || open);
        expect_connected(view, curve, -1);
        for (const SurfacePoint& point : curve.points) {
          EXPECT_NEAR(plane.normal.dot(position_of(view, point) - plane.point), 0, 1e-12 * 0.05);
        }
        seen.insert(seen.end(), curve.triangles.begin(), curve.triangles.end());
      }
      missed += seen.empty() ? 1 : 0;
      std::ranges::sort(seen);
      EXPECT_EQ(std::ranges::adjacent_find(seen), seen.end());
    }
  }
  EXPECT_LT(missed, 10) << "a plane through the ends of a cylinder may touch its border only";
}

}  // namespace
}  // namespace thinwall
