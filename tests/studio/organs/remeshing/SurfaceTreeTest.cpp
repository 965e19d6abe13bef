#include "studio/organs/remeshing/SurfaceTree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "engine/contact/ClosestPoint.hpp"
#include "engine/mesh/Shapes.hpp"

namespace thinwall {
namespace {

TEST(SurfaceTree, FindsWhatLookingAtEveryTriangleFinds) {
  const SurfaceMesh ball = make_sphere(1, 320);
  const SurfaceTree tree({ball.vertices, ball.triangles});
  std::mt19937 random(20260101);
  const auto coordinate = [&] { return static_cast<double>(random() % 4001) / 1000 - 2; };
  for (int trial = 0; trial < 300; ++trial) {
    const Eigen::Vector3d point(coordinate(), coordinate(), coordinate());
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3i& t : ball.triangles) {
      const std::array<Eigen::Vector3d, 3> corners = {ball.vertices[t[0]], ball.vertices[t[1]], ball.vertices[t[2]]};
      const Eigen::Vector3d weights = closest_point(corners, point).weights;
      const Eigen::Vector3d closest = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
      least = std::min(least, (closest - point).norm());
    }
    const NearestPoint found = tree.closest(point);
    EXPECT_EQ(found.distance, least);
    EXPECT_EQ((found.position - point).norm(), found.distance);
  }
}

TEST(SurfaceTree, FarSideOfAThinPlateDoesNotCount) {
  // Two sheets 0.1 apart that face away from each other.
  const SurfaceTree plate(
      {{{0, 0, 0.1}, {1, 0, 0.1}, {0, 1, 0.1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {3, 5, 4}}});
  const Eigen::Vector3d point(0.2, 0.2, 0.02);
  EXPECT_EQ(plate.closest(point).triangle, 1);
  EXPECT_EQ(plate.closest_facing(point, {0, 0, 1}).triangle, 0);
  EXPECT_NEAR(plate.closest_facing(point, {0, 0, 1}).distance, 0.08, 1e-15);
  // Where none faces that way, all count.
  EXPECT_EQ(plate.closest_facing(point, {1, 0, 0}).triangle, 1);
}

}  // namespace
}  // namespace thinwall
