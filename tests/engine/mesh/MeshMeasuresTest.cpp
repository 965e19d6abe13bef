#include "engine/mesh/MeshMeasures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace thinwall {
namespace {

/// The corner of a cube: right angles at the origin, edges of 1 along the axes, one face is the cap.
SurfaceMesh corner_at(const Eigen::Vector3d& origin) {
  SurfaceMesh mesh;
  mesh.vertices = {origin, origin + Eigen::Vector3d::UnitX(), origin + Eigen::Vector3d::UnitY(),
                   origin + Eigen::Vector3d::UnitZ()};
  mesh.triangles = {{0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  mesh.cap_triangles = {{0, 2, 1}};
  return mesh;
}

TEST(MeshMeasures, CornerHasASixthOfTheCube) {
  // Exact but for rounding: a few operations on numbers near 1.
  EXPECT_NEAR(enclosed_volume(corner_at(Eigen::Vector3d::Zero())), 1.0 / 6, 1e-16);
}

TEST(MeshMeasures, VolumeKeepsItsDigitsFarFromTheOrigin) {
  // The coordinates themselves are rounded to 1e-10 at 1e6; about the origin the terms would be 1e12 times the result.
  EXPECT_NEAR(enclosed_volume(corner_at({1e6, -1e6, 1e6})), 1.0 / 6, 1e-9);
}

TEST(MeshMeasures, TurnedSurfaceHasNegativeVolume) {
  SurfaceMesh mesh = corner_at(Eigen::Vector3d::Zero());
  for (Eigen::Vector3i& t : mesh.triangles) std::swap(t[0], t[1]);
  for (Eigen::Vector3i& t : mesh.cap_triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(enclosed_volume(mesh), -1.0 / 6, 1e-16);
}

TEST(MeshMeasures, SolidAnglesOfAClosedSurfaceAreTheWholeSphereFromInsideAndNoneFromOutside) {
  const SurfaceMesh mesh = corner_at(Eigen::Vector3d::Zero());
  const auto seen_from = [&](const Eigen::Vector3d& point) {
    double sum = 0;  // steradian
    for (const auto* triangles : {&mesh.triangles, &mesh.cap_triangles}) {
      for (const Eigen::Vector3i& t : *triangles) {
        sum += solid_angle({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}, point);
      }
    }
    return sum;
  };
  EXPECT_NEAR(seen_from({0.1, 0.2, 0.3}), 4 * std::numbers::pi, 1e-13);
  EXPECT_NEAR(seen_from({0.5, 0.6, 0.7}), 0, 1e-13);
}

TEST(MeshMeasures, WallAreaLeavesCapsOut) {
  EXPECT_NEAR(wall_area(corner_at(Eigen::Vector3d::Zero())), 1 + std::sqrt(3.0) / 2, 1e-15);
}

TEST(MeshMeasures, QualityOfTheCorner) {
  const MeshQuality quality = quality_of(corner_at(Eigen::Vector3d::Zero()));
  EXPECT_NEAR(quality.least_angle, std::numbers::pi / 4, 1e-15);
  EXPECT_NEAR(quality.median_angle, std::numbers::pi / 4, 1e-15);
  EXPECT_NEAR(quality.largest_angle, std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(quality.least_area, 0.5, 1e-15);
  EXPECT_NEAR(quality.largest_area, std::sqrt(3.0) / 2, 1e-15);
}

TEST(MeshMeasures, SliverAngleIsExactAndLostAreaGivesZero) {
  const std::vector<Eigen::Vector3d> vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0}, {2, 0, 0}};
  const std::vector<Eigen::Vector3i> triangles = {{0, 1, 2}, {0, 1, 3}};
  const std::vector<double> angles = smallest_angles(vertices, triangles);
  EXPECT_NEAR(angles[0], 1e-9, 1e-24);
  EXPECT_EQ(angles[1], 0);
}

}  // namespace
}  // namespace thinwall
