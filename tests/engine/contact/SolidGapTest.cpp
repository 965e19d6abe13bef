#include "engine/contact/SolidGap.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <limits>

#include "engine/contact/ClosestPoint.hpp"
#include "engine/contact/ContactPotential.hpp"
#include "tests/engine/HyperDual.hpp"

namespace thinwall {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

constexpr double kRadius = 0.5;
constexpr double kFar = std::numeric_limits<double>::infinity();

Corners some_corners() {
  return {Eigen::Vector3d(0.1, -0.2, 0.1), Eigen::Vector3d(1.3, 0.2, -0.1), Eigen::Vector3d(0.2, 0.9, 0.3)};
}

ToolSolid ball(const Eigen::Vector3d& center, double radius) {
  ToolSolid solid;
  solid.center = center;
  solid.radius = radius;
  return solid;
}

std::optional<SolidGap> ball_gap(const Eigen::Vector3d& center, double radius, double reach, const Corners& corners) {
  return solid_gap(ball(center, radius), reach, corners, SitePart::kFace);
}

TEST(SolidGap, IsTheSameWithoutItsHessianWhichIsThenZero) {
  for (const Eigen::Vector3d& center : {Eigen::Vector3d(0.5, 0.3, 0.7), Eigen::Vector3d(0.7, -0.5, 0.2)}) {
    for (const SitePart part : {SitePart::kCorner, SitePart::kEdge, SitePart::kFace}) {
      const auto whole = solid_gap(ball(center, kRadius), kFar, some_corners(), part);
      const auto quick = solid_gap(ball(center, kRadius), kFar, some_corners(), part, 0, GapTerms::kGradient);
      ASSERT_TRUE(whole && quick);
      EXPECT_EQ(quick->gap, whole->gap);
      EXPECT_EQ(quick->gradient, whole->gradient);
      EXPECT_TRUE(quick->hessian.isZero());
      EXPECT_FALSE(whole->hessian.isZero());
    }
  }
}

TEST(SolidGap, TheClosedFormOfABallOnAnEdgeIsTheRootThatACapsuleOfNoLengthHas) {
  // A capsule this short goes through the search for a root and differs from the ball by its own length.
  ToolSolid capsule = ball({0.7, -0.5, 0.2}, kRadius);
  capsule.core.z() = 1e-11;
  ASSERT_FALSE(capsule.is_ball());
  for (int edge = 0; edge < 3; ++edge) {
    const DeepestPoint root = deepest_on_edge(capsule, some_corners(), edge, (edge + 1) % 3);
    const DeepestPoint closed = deepest_on_edge(ball({0.7, -0.5, 0.2}, kRadius), some_corners(), edge, (edge + 1) % 3);
    EXPECT_EQ(closed.corner_count, root.corner_count) << edge;
    EXPECT_LT((closed.weights - root.weights).norm(), 1e-10) << edge;
  }
}

struct Example {
  const char* region;
  Eigen::Vector3d center;
  int corner_count;
  /// Distance from the centre by the formula of the region, independent of weights.
  std::function<HyperDual(const std::array<DualVector, 3>&, const DualVector&)> distance;
};

std::vector<Example> examples() {
  const auto face = [](const std::array<DualVector, 3>& x, const DualVector& center) {
    const DualVector normal = cross(x[1] - x[0], x[2] - x[0]);
    const HyperDual height = dot(center - x[0], normal) / norm(normal);
    return height.value < 0 ? -1 * height : height;
  };
  const auto edge = [](int from, int to) {
    return [from, to](const std::array<DualVector, 3>& x, const DualVector& center) {
      return norm(cross(center - x[from], x[to] - x[from])) / norm(x[to] - x[from]);
    };
  };
  const auto corner = [](int at) {
    return [at](const std::array<DualVector, 3>& x, const DualVector& center) { return norm(center - x[at]); };
  };
  return {{"face, above", {0.5, 0.3, 0.7}, 3, face},     {"face, below", {0.5, 0.3, -0.4}, 3, face},
          {"edge 0 1", {0.7, -0.5, 0.2}, 2, edge(0, 1)}, {"edge 1 2", {1.0, 0.9, 0.3}, 2, edge(1, 2)},
          {"edge 2 0", {-0.4, 0.3, 0.2}, 2, edge(2, 0)}, {"corner 0", {-0.3, -0.6, 0.2}, 1, corner(0)},
          {"corner 1", {1.7, 0.1, 0.1}, 1, corner(1)},   {"corner 2", {0.1, 1.4, 0.3}, 1, corner(2)}};
}

/// The rim of a jaw along y, and the gap of an edge above it that is tilted by `slope`.
ToolSolid rim(double crown) {
  ToolSolid solid;
  solid.role = ToolSolid::Role::kRim;
  solid.crown = crown;
  solid.core.y() = 1.5e-3;
  solid.radius = 0.5e-3;
  return solid;
}

Corners edge_over_rim(double slope) {
  return {Eigen::Vector3d(0, -4e-3, 0.49e-3 - 4e-3 * slope), Eigen::Vector3d(0, 4e-3, 0.49e-3 + 4e-3 * slope),
          Eigen::Vector3d(3e-3, 0, 1e-3)};
}

SolidGap gap_over_rim(const Corners& corners, double crown = 4e-3 * 0.5e-3) {
  return *solid_gap(rim(crown), kFar, corners, SitePart::kEdge);
}

TEST(RimGap, GoesSmoothlyFromEndToEndOfTheRimAsAnEdgeAlongItTilts) {
  EXPECT_NEAR(gap_over_rim(edge_over_rim(0)).weights[0], 0.5, 1e-12);
  for (const double slope : {-1e-2, -1.01e-4, -3e-5, 1e-9, 2e-5, 5e-5, 1e-3}) {
    const SolidGap gap = gap_over_rim(edge_over_rim(slope));
    // The deeper end is that which tilts towards the rim.
    EXPECT_GT((gap.weights[0] - 0.5) * slope, 0);
    EXPECT_NEAR(gap.gap, gap_over_rim(edge_over_rim(slope), 0).gap, 5.1e-4 * 0.5e-3);
    constexpr double kStep = 1e-9;  // metres
    for (int k = 0; k < 6; ++k) {
      Corners less = edge_over_rim(slope), more = less;
      less[k / 3][k % 3] -= kStep;
      more[k / 3][k % 3] += kStep;
      const SolidGap below = gap_over_rim(less), above = gap_over_rim(more);
      EXPECT_NEAR((above.gap - below.gap) / (2 * kStep), gap.gradient[k], 1e-6) << slope << " " << k;
      const Eigen::Matrix<double, 9, 1> change = (above.gradient - below.gradient) / (2 * kStep);
      EXPECT_LT((change - gap.hessian.col(k)).norm(), 1e-3 * (1 + gap.hessian.norm())) << slope << " " << k;
    }
  }
}

TEST(BallGap, GapGradientAndHessianAgreeWithExactDerivativesOfTheDistanceInEveryRegion) {
  // Both are exact; residuals seen below 3e-15.
  for (const Example& example : examples()) {
    ASSERT_EQ(closest_point(some_corners(), example.center).corner_count, example.corner_count) << example.region;
    const auto gap = ball_gap(example.center, kRadius, kFar, some_corners());
    ASSERT_TRUE(gap) << example.region;
    const CornerDerivatives exact = corner_derivatives(
        [&](const auto& x) { return example.distance(x, dual(example.center)) - kRadius; }, some_corners());
    EXPECT_NEAR(gap->gap, exact.value, 1e-14) << example.region;
    EXPECT_LT((gap->gradient - exact.gradient).cwiseAbs().maxCoeff(), 1e-14) << example.region;
    EXPECT_LT((gap->hessian - exact.hessian).cwiseAbs().maxCoeff(), 5e-14) << example.region;
    EXPECT_LT((gap->hessian - gap->hessian.transpose()).cwiseAbs().maxCoeff(), 1e-15) << example.region;
  }
}

TEST(BallGap, PushesTheTriangleAsAWholeByTheUnitNormal) {
  for (const Example& example : examples()) {
    const auto gap = ball_gap(example.center, kRadius, kFar, some_corners());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      sum += gap->gradient.segment<3>(3 * k);
      torque += (some_corners()[k] - example.center).cross(Eigen::Vector3d(gap->gradient.segment<3>(3 * k)));
    }
    EXPECT_NEAR(gap->normal.norm(), 1, 1e-15) << example.region;
    EXPECT_LT((sum - gap->normal).norm(), 1e-15) << example.region;
    // The force passes through the centre: a smooth sphere cannot turn the tissue about it.
    EXPECT_LT(torque.norm(), 1e-15) << example.region;
  }
}

TEST(BallGap, IsContinuousWithItsGradientWhereTheRegionsMeet) {
  // The distance to a convex set is once differentiable; the sphere rolls from face over edge to corner. Steps of 1e-6
  // change gap and gradient by less than 1e-5 where the curvature is at most about 10.
  const Corners corners = some_corners();
  std::optional<SolidGap> last;
  int changes = 0, last_count = 0;
  for (int k = 0; k <= 20000; ++k) {
    const Eigen::Vector3d center(0.6 + 1e-4 * k - 1, 0.25, 0.6);
    const auto gap = ball_gap(center, kRadius, kFar, corners);
    const int count = closest_point(corners, center).corner_count;
    if (last) {
      ASSERT_LT(std::abs(gap->gap - last->gap), 1.01e-4);
      ASSERT_LT((gap->gradient - last->gradient).cwiseAbs().maxCoeff(), 1e-3);
      changes += count != last_count;
    }
    last = gap;
    last_count = count;
  }
  EXPECT_GE(changes, 2);
}

TEST(BallGap, LetsAFlatFaceSlideAndTurnInItsPlaneWithoutResistance) {
  const Corners flat = {Eigen::Vector3d(-1, -1, 0), Eigen::Vector3d(2, -1, 0), Eigen::Vector3d(-1, 2, 0)};
  const auto gap = ball_gap({0, 0, kRadius}, kRadius, 1, flat);
  ASSERT_TRUE(gap);
  EXPECT_NEAR(gap->gap, 0, 1e-16);
  Eigen::Matrix<double, 9, 1> slide, turn, roll;
  for (int k = 0; k < 3; ++k) {
    slide.segment<3>(3 * k) = Eigen::Vector3d(0.3, -0.5, 0);
    turn.segment<3>(3 * k) = Eigen::Vector3d::UnitZ().cross(flat[k]);
    roll.segment<3>(3 * k) = Eigen::Vector3d::UnitX().cross(flat[k] - Eigen::Vector3d(0, 0, kRadius));
  }
  EXPECT_LT(std::abs(gap->gradient.dot(slide)) + std::abs(slide.dot(gap->hessian * slide)), 1e-15);
  EXPECT_LT(std::abs(gap->gradient.dot(turn)) + std::abs(turn.dot(gap->hessian * turn)), 1e-15);
  EXPECT_LT(std::abs(gap->gradient.dot(roll)), 1e-15);  // about the centre
}

TEST(BallGap, GivesNothingBeyondItsReachAndEverythingWithinIt) {
  const Corners flat = {Eigen::Vector3d(-1, -1, 0), Eigen::Vector3d(2, -1, 0), Eigen::Vector3d(-1, 2, 0)};
  EXPECT_FALSE(ball_gap({0, 0, 0.6}, 0.5, 0.0999, flat));
  EXPECT_TRUE(ball_gap({0, 0, 0.6}, 0.5, 0.1001, flat));
  EXPECT_FALSE(ball_gap({20, 0, 0}, 0.5, 0.1, flat));
  EXPECT_TRUE(ball_gap({20, 0, 0}, 0.5, kFar, flat));
  EXPECT_NEAR(ball_gap({0, 0, 0.2}, 0.5, 0.1, flat)->gap, -0.3, 1e-15);
}

TEST(ContactPotential, ForceIsTheSlopeOfTheEnergyAndSetsInAtTheOnset) {
  const ContactPotential potential{.onset = 2e-6, .stiffness = 1.5e6};
  EXPECT_EQ(potential.energy(2e-6), 0);
  EXPECT_EQ(potential.energy(5e-6), 0);
  EXPECT_NEAR(potential.energy(0), 0.5 * 3 * 2e-6, 1e-20);  // a linear spring from 0 to 3 N over 2 um
  for (const double gap : {-1e-6, 0.0, 1e-6, 1.9e-6}) {
    // A quadratic: the central difference is exact but for round-off.
    const double h = 1e-8, slope = (potential.energy(gap + h) - potential.energy(gap - h)) / (2 * h);
    EXPECT_NEAR(-slope, potential.spring_force(gap), 1e-6) << gap;
  }
}

}  // namespace
}  // namespace thinwall
