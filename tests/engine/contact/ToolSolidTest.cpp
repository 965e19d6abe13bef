#include "engine/contact/ToolSolid.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "engine/contact/DeepestPoint.hpp"
#include "engine/contact/SolidGap.hpp"

namespace thinwall {
namespace {

Eigen::Matrix3d some_frame() {
  return Eigen::AngleAxisd(0.8, Eigen::Vector3d(0.3, -0.5, 0.7).normalized()).toRotationMatrix();
}

ToolSolid rounded_box(const Eigen::Vector3d& core, double radius) {
  ToolSolid solid;
  solid.center = {0.1, -0.2, 0.3};
  solid.frame = some_frame();
  solid.core = core;
  solid.radius = radius;
  return solid;
}

ToolSolid needle() {
  ToolSolid solid = rounded_box({0, 0, 1}, 0.2);
  solid.form = ToolSolid::Form::kNeedle;
  solid.tip_radius = 0.03;
  solid.shoulder = 0.3;
  return solid;
}

struct Named {
  const char* name;
  ToolSolid solid;
};
std::vector<Named> solids() {
  return {{"ball", rounded_box({0, 0, 0}, 0.5)},          {"capsule", rounded_box({0, 0.7, 0}, 0.2)},
          {"plate", rounded_box({0.8, 0.6, 0.05}, 0.05)}, {"blade", rounded_box({0, 0.4, 0.9}, 0.1)},
          {"jaw", rounded_box({0.1, 0.2, 0.8}, 0.1)},     {"needle", needle()}};
}

/// Points outside of a solid, down to its surface and a little deeper than that.
std::vector<Eigen::Vector3d> points_near(const ToolSolid& solid, int count) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> number(-1.5, 1.5);
  std::vector<Eigen::Vector3d> points;
  while (static_cast<int>(points.size()) < count) {
    const Eigen::Vector3d point(number(generator), number(generator), number(generator));
    if (signed_distance(solid, point).value > -0.5 * solid.sharpness()) points.push_back(point);
  }
  return points;
}

/// Distance from the union of balls whose hull a solid is: a dense set of them. No less than that from the hull.
double distance_from_balls(const ToolSolid& solid, const Eigen::Vector3d& point) {
  const Eigen::Vector3d local = solid.frame.transpose() * (point - solid.center);
  double least = 1e9;
  if (solid.form == ToolSolid::Form::kNeedle) {
    constexpr int kBalls = 4000;
    for (int k = 0; k <= kBalls; ++k) {
      const double z = -solid.core.z() + 2 * solid.core.z() * k / kBalls;
      const double along = std::max(0.0, (z - solid.shoulder) / (solid.core.z() - solid.shoulder));
      const double radius = solid.radius + along * (solid.tip_radius - solid.radius);
      least = std::min(least, (local - Eigen::Vector3d(0, 0, z)).norm() - radius);
    }
    return least;
  }
  return (local - local.cwiseMax(-solid.core).cwiseMin(solid.core)).norm() - solid.radius;
}

TEST(ToolSolid, DistanceIsThatOfTheBallsThatMakeUpTheSolid) {
  for (const auto& [name, solid] : solids()) {
    for (const Eigen::Vector3d& point : points_near(solid, 200)) {
      const double value = signed_distance(solid, point).value;
      // Between neighbouring balls of the dense set at most 1e-6 is missed.
      EXPECT_NEAR(value, distance_from_balls(solid, point), 2e-6) << name;
    }
  }
}

TEST(ToolSolid, DistanceAloneIsTheSameToTheBit) {
  for (const auto& [name, solid] : solids()) {
    std::vector<Eigen::Vector3d> points = points_near(solid, 200);
    for (const double part : {0.0, 0.3, 0.9}) points.push_back(solid.center + solid.frame * (part * solid.core));
    for (const Eigen::Vector3d& point : points) {
      EXPECT_EQ(distance_from(solid, point), signed_distance(solid, point).value) << name;
    }
  }
}

TEST(ToolSolid, NormalAndCurvatureAreTheDerivativesOfTheDistance) {
  constexpr double h = 1e-5;
  for (const auto& [name, solid] : solids()) {
    int judged = 0;
    for (const Eigen::Vector3d& point : points_near(solid, 300)) {
      const SignedDistance here = signed_distance(solid, point);
      EXPECT_NEAR(here.normal.norm(), 1, 1e-14) << name;
      EXPECT_LT((here.curvature * here.normal).norm(), 1e-11) << name;
      Eigen::Matrix3d slope;
      bool even = true;
      for (int axis = 0; axis < 3; ++axis) {
        const SignedDistance after = signed_distance(solid, point + h * Eigen::Vector3d::Unit(axis));
        const SignedDistance before = signed_distance(solid, point - h * Eigen::Vector3d::Unit(axis));
        // Second differences of a function of curvature up to 1 / 0.015: seen below 3e-7.
        EXPECT_NEAR((after.value - before.value) / (2 * h), here.normal[axis], 1e-6) << name;
        slope.col(axis) = (after.normal - before.normal) / (2 * h);
        // Across the border of two regions the curvature jumps.
        even = even && (after.curvature - before.curvature).norm() < 0.01 * (1 + here.curvature.norm());
      }
      if (!even) continue;
      ++judged;
      EXPECT_LT((slope - here.curvature).norm(), 1e-5 * (1 + here.curvature.squaredNorm())) << name;
    }
    EXPECT_GT(judged, 200) << name;
  }
}

TEST(ToolSolid, InsideItsCoreAPointLeavesThroughTheNearestFace) {
  const ToolSolid plate = rounded_box({0.8, 0.6, 0.05}, 0.05);
  const SignedDistance distance = signed_distance(plate, plate.center + plate.frame * Eigen::Vector3d(0.3, 0.2, -0.03));
  EXPECT_NEAR(distance.value, -0.07, 1e-15);
  EXPECT_LT((distance.normal + plate.frame.col(2)).norm(), 1e-15);
}

TEST(ToolSolid, MovesItsPointsAsARigidBody) {
  const ToolSolid before = rounded_box({0.1, 0.2, 0.8}, 0.1);
  ToolSolid after = before;
  after.center += Eigen::Vector3d(0.3, 0.1, -0.2);
  after.frame = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()) * before.frame;
  const Eigen::Vector3d local(0.05, -0.3, 0.6);
  const Eigen::Vector3d from = before.center + before.frame * local, to = after.center + after.frame * local;
  EXPECT_LT((from + displacement_of(before, after, from) - to).norm(), 1e-15);
}

using Corners = std::array<Eigen::Vector3d, 3>;

std::vector<Corners> triangles_near(const ToolSolid& solid, int count) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Corners> triangles;
  while (static_cast<int>(triangles.size()) < count) {
    Corners corners;
    const Eigen::Vector3d middle(number(generator), number(generator), number(generator));
    for (Eigen::Vector3d& corner : corners) {
      corner = middle + 0.7 * Eigen::Vector3d(number(generator), number(generator), number(generator));
    }
    const auto gap = solid_gap(solid, 10, corners, SitePart::kFace);
    if (gap->gap > -0.5 * solid.sharpness() && gap->gap < 0.5) triangles.push_back(corners);
  }
  return triangles;
}

TEST(DeepestPoint, IsAsDeepAsAnyPointOfTheTriangle) {
  for (const auto& [name, solid] : solids()) {
    int inside = 0, on_edge = 0;
    for (const Corners& corners : triangles_near(solid, 150)) {
      const DeepestPoint deepest = deepest_on_triangle(solid, corners);
      const auto gap = solid_gap(solid, 10, corners, SitePart::kFace);
      inside += deepest.corner_count == 3;
      on_edge += deepest.corner_count == 2;
      EXPECT_NEAR(deepest.weights.sum(), 1, 1e-15) << name;
      EXPECT_GE(deepest.weights.minCoeff(), 0) << name;
      constexpr int kSteps = 60;
      for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; i + j <= kSteps; ++j) {
          const Eigen::Vector3d point =
              (i * corners[0] + j * corners[1] + (kSteps - i - j) * corners[2]) / static_cast<double>(kSteps);
          EXPECT_GE(signed_distance(solid, point).value, gap->gap - 1e-12) << name;
        }
      }
    }
    EXPECT_GT(inside, 3) << name;
    EXPECT_GT(on_edge, 10) << name;
  }
}

TEST(DeepestPoint, IsFoundAtTheCornerOfABladeSmallerThanTheTriangle) {
  ToolSolid blade;
  blade.core = {0, 0.28, 0.98};
  blade.radius = 0.02;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> number(-1, 1);
  int inside = 0;
  for (int k = 0; k < 4000; ++k) {
    const Eigen::Vector3d middle(0.03 * number(generator), 0.28 + 0.1 * number(generator), 1);
    Corners corners;
    for (Eigen::Vector3d& corner : corners) {
      corner = middle + 0.1 * Eigen::Vector3d(number(generator), number(generator), 0.3 * number(generator));
    }
    const auto gap = solid_gap(blade, 1, corners, SitePart::kFace);
    if (gap->gap < -0.015) continue;
    inside += gap->part == SitePart::kFace;
    for (int probe = 0; probe < 60; ++probe) {
      Eigen::Vector3d weights(number(generator), number(generator), number(generator));
      weights = weights.cwiseAbs() / weights.cwiseAbs().sum();
      const Eigen::Vector3d point = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
      EXPECT_GE(signed_distance(blade, point).value, gap->gap - 1e-12);
    }
  }
  EXPECT_GT(inside, 100);
}

TEST(SolidGap, GradientAndHessianAreTheDerivativesOfTheGapOfEveryPart) {
  constexpr double h = 1e-6;
  for (const auto& [name, solid] : solids()) {
    for (const SitePart part : {SitePart::kCorner, SitePart::kEdge, SitePart::kFace}) {
      int judged = 0;
      for (const Corners& corners : triangles_near(solid, 60)) {
        const auto here = solid_gap(solid, 10, corners, part, 1);
        if (here->gap < -0.5 * solid.sharpness()) continue;
        Eigen::Matrix<double, 9, 9> slope;
        bool even = true;
        for (int k = 0; k < 9; ++k) {
          Corners after = corners, before = corners;
          after[k / 3][k % 3] += h;
          before[k / 3][k % 3] -= h;
          const auto ahead = solid_gap(solid, 10, after, part, 1), behind = solid_gap(solid, 10, before, part, 1);
          EXPECT_NEAR((ahead->gap - behind->gap) / (2 * h), here->gradient[k], 2e-4) << name;
          slope.col(k) = (ahead->gradient - behind->gradient) / (2 * h);
          even = even && (ahead->hessian - behind->hessian).norm() < 1e-3 * (1 + here->hessian.norm());
        }
        if (!even) continue;  // across the border of two regions the Hessian jumps
        ++judged;
        EXPECT_LT((slope - here->hessian).norm(), 1e-3 * (1 + here->hessian.norm())) << name;
      }
      EXPECT_GT(judged, 20) << name << static_cast<int>(part);
    }
  }
}

TEST(ToolSolid, HasItsExtremePointInEveryDirectionOnOneOfItsCorners) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const auto& [name, solid] : solids()) {
    const std::vector<ToolSolid> corners = corners_of(solid);
    EXPECT_EQ(corners.empty(), solid.is_ball()) << name;
    for (int k = 0; k < 50 && !corners.empty(); ++k) {
      const Eigen::Vector3d direction =
          Eigen::Vector3d(number(generator), number(generator), number(generator)).normalized();
      Eigen::Vector3d extreme = solid.center;
      for (const ToolSolid& corner : corners) {
        EXPECT_EQ(corner.role, ToolSolid::Role::kCorner);
        const Eigen::Vector3d point = corner.center + corner.radius * direction;
        if (direction.dot(point - extreme) > 0) extreme = point;
      }
      const SignedDistance distance = signed_distance(solid, extreme);
      EXPECT_NEAR(distance.value, 0, 1e-12) << name;
      EXPECT_NEAR(distance.normal.dot(direction), 1, 1e-12) << name;
    }
  }
}

TEST(ToolSolid, RimsOfABoxRunAlongItsEdges) {
  for (const auto& [name, solid] : solids()) {
    const bool is_flat = solid.form == ToolSolid::Form::kRoundedBox && (solid.core.array() > 0).count() > 1;
    const std::vector<ToolSolid> rims = rims_of(solid);
    const std::size_t count = !is_flat ? 0 : (solid.core.array() > 0).all() ? 12 : 4;
    EXPECT_EQ(rims.size(), count) << name;
    for (const ToolSolid& rim : rims) {
      EXPECT_EQ(rim.role, ToolSolid::Role::kRim);
      // Where the rim is outermost it lies on the solid, all along.
      const Eigen::Vector3d outwards = (rim.center - solid.center).normalized();
      for (const double place : {-1.0, 0.3, 1.0}) {
        const Eigen::Vector3d point = rim.center + rim.frame * (place * rim.core) + rim.radius * outwards;
        EXPECT_NEAR(signed_distance(solid, point).value, 0, 1e-12) << name;
      }
    }
  }
}

}  // namespace
}  // namespace thinwall
