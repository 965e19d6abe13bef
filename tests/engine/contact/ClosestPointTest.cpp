#include "engine/contact/ClosestPoint.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace thinwall {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

/// Right angle at the origin, legs of 1 along x and y.
Corners right_triangle() {
  return {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0)};
}

Eigen::Vector3d position_of(const ClosestPoint& closest, const Corners& corners) {
  return closest.weights[0] * corners[0] + closest.weights[1] * corners[1] + closest.weights[2] * corners[2];
}

struct Example {
  const char* region;
  Eigen::Vector3d point, closest;
  int corner_count;
  std::vector<int> corners;  // that may take part, ascending
};

TEST(ClosestPoint, LiesWhereItShouldInAllSevenVoronoiRegions) {
  const std::vector<Example> examples = {
      {"face, above", {0.2, 0.3, 0.7}, {0.2, 0.3, 0}, 3, {0, 1, 2}},
      {"face, below", {0.2, 0.3, -0.7}, {0.2, 0.3, 0}, 3, {0, 1, 2}},
      {"edge 0 1", {0.4, -0.5, 0.3}, {0.4, 0, 0}, 2, {0, 1}},
      {"edge 1 2", {0.9, 0.7, 0.3}, {0.6, 0.4, 0}, 2, {1, 2}},
      {"edge 2 0", {-0.5, 0.4, 0.3}, {0, 0.4, 0}, 2, {0, 2}},
      {"corner 0", {-0.5, -0.4, 0.3}, {0, 0, 0}, 1, {0}},
      {"corner 1", {2, 0.5, 0.3}, {1, 0, 0}, 1, {1}},
      {"corner 2", {0.5, 2, 0.3}, {0, 1, 0}, 1, {2}},
  };
  for (const Example& example : examples) {
    const ClosestPoint closest = closest_point(right_triangle(), example.point);
    EXPECT_LT((position_of(closest, right_triangle()) - example.closest).norm(), 1e-15) << example.region;
    ASSERT_EQ(closest.corner_count, example.corner_count) << example.region;
    std::vector<int> corners(closest.corners.begin(), closest.corners.begin() + closest.corner_count);
    std::sort(corners.begin(), corners.end());
    EXPECT_EQ(corners, example.corners) << example.region;
    EXPECT_NEAR(closest.weights.sum(), 1, 1e-15) << example.region;
  }
}

TEST(ClosestPoint, ObtuseTriangleSendsPointsBeyondItsLongSideToTheRightPlace) {
  // With an angle of 135 degrees at corner 0 a point may lie outside two edges and still be closest to the third.
  const Corners obtuse = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 1, 0)};
  const ClosestPoint corner = closest_point(obtuse, {-0.1, -1, 0});
  EXPECT_EQ(corner.corner_count, 1);
  EXPECT_EQ(corner.corners[0], 0);
  const ClosestPoint edge = closest_point(obtuse, {-1, 0.5, 0.2});
  EXPECT_EQ(edge.corner_count, 2);
  EXPECT_LT((position_of(edge, obtuse) - Eigen::Vector3d(-0.75, 0.75, 0)).norm(), 1e-15);
}

TEST(ClosestPoint, IsNearerThanEveryOtherPointOfTheTriangle) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-2, 2);
  const auto vector = [&] { return Eigen::Vector3d(number(random), number(random), number(random)); };
  for (int trial = 0; trial < 200; ++trial) {
    const Corners corners = {vector(), vector(), vector()};
    const Eigen::Vector3d point = vector();
    const ClosestPoint closest = closest_point(corners, point);
    EXPECT_GE(closest.weights.minCoeff(), 0);
    const double distance = (position_of(closest, corners) - point).norm();
    constexpr int kSteps = 40;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const double a = double(i) / kSteps, b = double(j) / kSteps;
        const Eigen::Vector3d other = a * corners[0] + b * corners[1] + (1 - a - b) * corners[2];
        ASSERT_LE(distance, (other - point).norm() + 1e-14) << "trial " << trial;
      }
    }
  }
}

TEST(ClosestPoint, MovesContinuouslyAcrossTheRegions) {
  // The closest point of a convex set moves no faster than the point itself: along a circle through all regions the
  // step of the one is at most the step of the other. Round-off seen: 3e-16.
  for (const double height : {0.0, 0.3}) {
    Eigen::Vector3d last_point = Eigen::Vector3d::Zero(), last_closest = Eigen::Vector3d::Zero();
    constexpr int kSteps = 20000;
    for (int k = 0; k <= kSteps; ++k) {
      const double angle = 2 * std::numbers::pi * k / kSteps;
      const Eigen::Vector3d point(0.3 + 0.45 * std::cos(angle), 0.3 + 0.45 * std::sin(angle), height);
      const Eigen::Vector3d closest = position_of(closest_point(right_triangle(), point), right_triangle());
      if (k > 0) {
        ASSERT_LE((closest - last_closest).norm(), (point - last_point).norm() + 1e-14) << k;
      }
      last_point = point;
      last_closest = closest;
    }
  }
}

TEST(ClosestPoint, NeedleThinTriangleStillGivesAPointOfItself) {
  const Corners thin = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.5, 1e-9, 0)};
  const ClosestPoint closest = closest_point(thin, {0.4, 0.2, 0.1});
  EXPECT_GE(closest.weights.minCoeff(), 0);
  EXPECT_LT((position_of(closest, thin) - Eigen::Vector3d(0.4, 0, 0)).norm(), 1e-8);
}

}  // namespace
}  // namespace thinwall
