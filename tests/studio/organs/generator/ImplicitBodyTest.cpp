#include "studio/organs/generator/ImplicitBody.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

/// Points around a body of about 20 mm.
std::vector<Eigen::Vector3d> probes() {
  std::vector<Eigen::Vector3d> points;
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) {
      for (int k = -2; k <= 2; ++k) points.emplace_back(0.0051 * i + 0.0007, 0.0043 * j - 0.0011, 0.0047 * k + 0.0003);
    }
  }
  return points;
}

void expect_true_gradient(const ImplicitBody& body) {
  constexpr double kStep = 1e-7;  // metres
  for (const Eigen::Vector3d& point : probes()) {
    const FieldValue field = body(point);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
      const double slope = (body(point + step).value - body(point - step).value) / (2 * kStep);
      // The search for the nearest sphere stops short of it: 4e-5 was seen.
      EXPECT_NEAR(field.gradient[axis], slope, 2e-4) << point.transpose();
    }
  }
}

const std::vector<AxisPoint> kBentAxis = {{{-0.01, 0, 0}, 0.004},
                                          {{-0.004, 0.004, 0}, 0.005},
                                          {{0.003, 0.004, 0.003}, 0.004},
                                          {{0.01, -0.002, 0.002}, 0.002}};

TEST(ImplicitBody, GradientsAreThoseOfTheField) {
  const ImplicitBody sphere = sphere_body({0.002, 0, 0}, 0.008);
  const ImplicitBody tube = swept_sphere_body(kBentAxis);
  expect_true_gradient(sphere);
  expect_true_gradient(half_space_body({0, 0, 0.001}, Eigen::Vector3d(0.6, 0, 0.8)));
  expect_true_gradient(tube);
  expect_true_gradient(smooth_union(sphere, tube, 0.004));
  expect_true_gradient(smooth_intersection(sphere, tube, 0.004));
  expect_true_gradient(outside_of(sphere));
  expect_true_gradient(stretched_body(sphere, {1.5, 0.5, 1}));
}

TEST(ImplicitBody, OutsideIsWhatTheBodyIsNot) {
  const ImplicitBody sphere = sphere_body({0, 0, 0}, 0.01);
  for (const Eigen::Vector3d& point : probes()) EXPECT_EQ(outside_of(sphere)(point).value, -sphere(point).value);
}

TEST(ImplicitBody, StretchedSphereIsAnEllipsoidWhoseValueStaysBelowTheDistance) {
  const ImplicitBody ellipsoid = stretched_body(sphere_body({0, 0, 0}, 0.01), {2, 1, 0.5});
  EXPECT_NEAR(ellipsoid({0.02, 0, 0}).value, 0, 1e-15);
  EXPECT_NEAR(ellipsoid({0, 0.01, 0}).value, 0, 1e-15);
  EXPECT_NEAR(ellipsoid({0, 0, 0.005}).value, 0, 1e-15);
  for (const double beyond : {0.001, 0.004}) {
    EXPECT_LE(ellipsoid({0.02 + beyond, 0, 0}).value, beyond);
    EXPECT_LE(ellipsoid({0, 0, 0.005 + beyond}).value, beyond + 1e-15);
  }
}

TEST(ImplicitBody, StraightSweepOfOneRadiusIsACapsule) {
  const ImplicitBody capsule = swept_sphere_body({{{0, 0, 0}, 0.003}, {{0.01, 0, 0}, 0.003}, {{0.02, 0, 0}, 0.003}});
  EXPECT_NEAR(capsule({0.01, 0.005, 0}).value, 0.002, 1e-9);
  EXPECT_NEAR(capsule({-0.004, 0, 0}).value, 0.001, 1e-9);
  EXPECT_NEAR(capsule({0.024, 0, 0}).value, 0.001, 1e-9);
  // The place of the nearest sphere is off by 3e-4 of the way between samples, which counts to second order beside the
  // axis. On the axis the place counts to first order.
  EXPECT_NEAR(capsule({0.01, 0, 0}).value, -0.003, 1e-6);
}

TEST(ImplicitBody, BlendsReachNoFartherThanTheirBreadth) {
  const ImplicitBody a = sphere_body({0, 0, 0}, 0.01);
  const ImplicitBody b = sphere_body({0.015, 0, 0}, 0.01);
  const ImplicitBody both = smooth_union(a, b, 0.004);
  EXPECT_EQ(both({-0.011, 0, 0}).value, a({-0.011, 0, 0}).value);
  // Half-way the two are equal: the union is lower by a sixth of the blend.
  EXPECT_NEAR(both({0.0075, 0, 0}).value, -0.0025 - 0.004 / 6, 1e-15);
  EXPECT_NEAR(smooth_intersection(a, b, 0.004)({0.0075, 0, 0}).value, -0.0025 + 0.004 / 6, 1e-15);
}

TEST(ImplicitBody, ProjectionReachesTheSurface) {
  const ImplicitBody body = smooth_union(sphere_body({0, 0, 0}, 0.01), swept_sphere_body(kBentAxis), 0.004);
  for (const Eigen::Vector3d& point : probes()) {
    EXPECT_NEAR(body(project_to_surface(body, point)).value, 0, 1e-9) << point.transpose();
  }
}

}  // namespace
}  // namespace thinwall
