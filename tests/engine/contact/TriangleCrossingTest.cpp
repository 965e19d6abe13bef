#include "engine/contact/TriangleCrossing.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

namespace thinwall {
namespace {

using Eigen::Vector3d;

MovingTriangle triangle_moved_by(const Vector3d& way) {
  const std::array<Vector3d, 3> corners = {Vector3d(0, 0, 0), Vector3d(3, 0, 0), Vector3d(0, 3, 0)};
  return {.from = corners, .to = {corners[0] + way, corners[1] + way, corners[2] + way}};
}

TEST(TriangleCrossing, IsAPointThatGoesThroughATriangleAtRest) {
  const MovingTriangle still = triangle_moved_by({0, 0, 0});
  EXPECT_TRUE(goes_through({1, 1, 1}, {1, 1, -1}, still));
  EXPECT_TRUE(goes_through({1, 1, -1}, {1, 1, 1}, still)) << "from behind, too";
  EXPECT_FALSE(goes_through({1, 1, 1}, {1, 1, 0.1}, still)) << "stops before";
  EXPECT_FALSE(goes_through({2, 2, 1}, {2, 2, -1}, still)) << "beside";
  EXPECT_FALSE(goes_through({-1, 1, 0.5}, {4, 1, 0.5}, still)) << "above";
}

TEST(TriangleCrossing, IsATriangleThatGoesOverAPointAtRest) {
  const Vector3d point(1, 1, 0.5);
  EXPECT_TRUE(goes_through(point, point, triangle_moved_by({0, 0, 1})));
  EXPECT_FALSE(goes_through(point, point, triangle_moved_by({2, 0, 0}))) << "slides along below it";
  EXPECT_FALSE(goes_through(point, point + Vector3d(0, 0, 1), triangle_moved_by({0, 0, 1}))) << "goes with it";
}

TEST(TriangleCrossing, IsMissedByNoneOfTwoTrianglesOverTheEdgeThatTheyShare) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto somewhere = [&] { return Vector3d(place(engine), place(engine), place(engine)); };
  for (int k = 0; k < 2000; ++k) {
    const Vector3d first = somewhere(), last = somewhere(), left = somewhere(), right = first + last - left;
    const MovingTriangle one{.from = {first, last, left}, .to = {first, last, left}};
    const MovingTriangle other{.from = {last, first, right}, .to = {last, first, right}};
    const Vector3d over = first + 0.5 * (1 + place(engine)) * (last - first), way = somewhere();
    EXPECT_TRUE(goes_through(over - way, over + way, one) || goes_through(over - way, over + way, other)) << k;
  }
}

/// Whether the point is found on the other side, within the triangle, from one of many moments to the next.
bool crosses_by_moments(const Vector3d& from, const Vector3d& to, const MovingTriangle& triangle) {
  constexpr int kMoments = 2000;
  double before = 0;
  for (int k = 0; k <= kMoments; ++k) {
    const double time = static_cast<double>(k) / kMoments;
    const auto at = [time](const Vector3d& start, const Vector3d& end) {
      return Vector3d(start + time * (end - start));
    };
    const Vector3d corner = at(triangle.from[0], triangle.to[0]);
    const Vector3d a = at(triangle.from[1], triangle.to[1]) - corner, b = at(triangle.from[2], triangle.to[2]) - corner;
    const Vector3d c = at(from, to) - corner, normal = a.cross(b);
    const double side = c.dot(normal);
    const double second = c.cross(b).dot(normal), third = a.cross(c).dot(normal);
    const bool is_over = second > 0 && third > 0 && second + third < normal.squaredNorm();
    if (k > 0 && side * before < 0 && is_over) return true;
    before = side;
  }
  return false;
}

TEST(TriangleCrossing, AgreesWithManyMomentsOfRandomMotions) {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto somewhere = [&] { return Vector3d(place(engine), place(engine), place(engine)); };
  int through = 0, differing = 0;
  constexpr int kMotions = 2000;
  for (int k = 0; k < kMotions; ++k) {
    const MovingTriangle triangle{.from = {somewhere(), somewhere(), somewhere()},
                                  .to = {somewhere(), somewhere(), somewhere()}};
    const Vector3d from = 0.5 * somewhere(), to = 0.5 * somewhere();
    const bool crosses = goes_through(from, to, triangle);
    through += crosses;
    differing += crosses != crosses_by_moments(from, to, triangle);
  }
  EXPECT_GT(through, kMotions / 10);
  // One that passes an edge, or turns back, between two moments may; none of these does.
  EXPECT_EQ(differing, 0);
}

}  // namespace
}  // namespace thinwall
