#include "engine/contact/SelfIntersections.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/contact/SurfaceIntersections.hpp"

namespace thinwall {
namespace {

Eigen::VectorXd positions_of(const SurfaceMesh& mesh) {
  Eigen::VectorXd position(3 * static_cast<Eigen::Index>(mesh.vertices.size()));
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    position.segment<3>(3 * static_cast<Eigen::Index>(v)) = mesh.vertices[v];
  }
  return position;
}

TEST(SelfIntersections, AnEdgePassesThroughATriangleAndItsSidesButNotWhereItEndsThere) {
  const std::array<Eigen::Vector3d, 3> triangle = {Eigen::Vector3d(0, 0, 0), {1, 0, 0}, {0, 1, 0}};
  const auto passes = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return passes_through({from, to}, triangle);
  };
  EXPECT_TRUE(passes({0.25, 0.25, -1}, {0.25, 0.25, 1}));
  EXPECT_TRUE(passes({0.25, 0.25, 1}, {0.25, 0.25, -1}));
  EXPECT_FALSE(passes({0.75, 0.75, -1}, {0.75, 0.75, 1})) << "beside";
  EXPECT_FALSE(passes({0.25, 0.25, 0}, {0.25, 0.25, 1})) << "an end touches";
  EXPECT_TRUE(passes({0.25, 0, -1}, {0.25, 0, 1})) << "through a side, which is the next triangle's too";
  EXPECT_FALSE(passes({0.25, -1e-4, -1}, {0.25, -1e-4, 1})) << "close beside";
  EXPECT_FALSE(passes({0.25, 0.25, 0.5}, {0.25, 0.25, 1})) << "ends before";
}

TEST(SelfIntersections, ARoundSurfaceHasNone) {
  const SurfaceMesh ball = make_sphere(20e-3, 2000);
  EXPECT_TRUE(self_intersections(ball.triangles, positions_of(ball)).empty());
}

TEST(SelfIntersections, AreThoseOfAllEdgesAgainstAllTriangles) {
  // The north is pushed through the south.
  const SurfaceMesh ball = make_sphere(20e-3, 2000);
  Eigen::VectorXd position = positions_of(ball);
  for (Eigen::Index k = 0; k < position.size(); k += 3) {
    const double aside = position.segment<2>(k).norm() / 4e-3;
    if (position[k + 2] > 0) position[k + 2] -= 60e-3 * std::exp(-aside * aside);
  }
  std::vector<SurfaceIntersection> expected = surface_intersections(ball.triangles, position);
  std::sort(expected.begin(), expected.end());
  ASSERT_GT(expected.size(), 10u);
  EXPECT_EQ(self_intersections(ball.triangles, position), expected);
}

}  // namespace
}  // namespace thinwall
