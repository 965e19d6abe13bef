// A fluid-filled semicylinder in plane strain under a straight edge, against its exact solution.
//
// Each half of the section is a membrane under even pressure without shear along it, so its tension T is constant and
// it is an arc of a circle of radius r = T / p, through the base edge (R, 0) and the crown (0, R - d). Incompressible
// fluid keeps the area of a half, pi R^2 / 4: triangle plus circular segment. Constant tension means constant stretch,
// l = arc length / (pi R / 2), and in plane strain T = mu h (l - l^-3). The arc leaves the crown rising by an angle phi
// against the horizontal, and the two halves hold the force per length F = 2 T sin(phi).

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kRadius = 10e-3, kThickness = 1e-3, kModulus = 20e3;

struct ExactSection {
  double force;            // newton / metre
  double pressure;         // pascal
  double radius;           // metres, of the arcs
  Eigen::Vector2d center;  // (x, z) of the arc on the side x > 0, metres
};

ExactSection exact_section(double depth) {
  const double pi = std::numbers::pi;
  const Eigen::Vector2d base(kRadius, 0), crown(0, kRadius - depth);
  const double chord = (crown - base).norm(), triangle = 0.5 * kRadius * (kRadius - depth);
  // Segment area by the half angle a of the arc: r^2 (a - sin a cos a), r = chord / (2 sin a). It grows with a.
  const auto segment = [&](double a) {
    const double r = 0.5 * chord / std::sin(a);
    return r * r * (a - std::sin(a) * std::cos(a));
  };
  double low = 1e-6, high = pi - 1e-3;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (triangle + segment(middle) < 0.25 * pi * kRadius * kRadius ? low : high) = middle;
  }
  const double a = 0.5 * (low + high), radius = 0.5 * chord / std::sin(a);
  const double stretch = 2 * a * radius / (0.5 * pi * kRadius);
  const double tension = kModulus * kThickness * (stretch - std::pow(stretch, -3));
  // The tangent at the crown is the chord turned up by a; the chord itself falls from crown to base.
  const double fall = std::atan2(crown.y(), base.x());
  const Eigen::Vector2d along = (crown - base).normalized(), inward(-along.y(), along.x());
  return {.force = 2 * tension * std::sin(a - fall),
          .pressure = tension / radius,
          .radius = radius,
          .center = 0.5 * (base + crown) + radius * std::cos(a) * inward};
}

TEST(Fingerpad, ExactSolutionHasTheForceThatWasWorkedOutByHand) {
  // 4 mm deep, 10 mm long.
  EXPECT_NEAR(10e-3 * exact_section(4e-3).force, 0.12665, 5e-6);
  EXPECT_NEAR(exact_section(1e-9).force, 0, 1e-6);
  EXPECT_NEAR(exact_section(1e-9).radius, kRadius, 1e-8);
}

/// Largest distance of a vertex from the exact arc of its side, metres.
double off_the_arc(const Body& body, const ExactSection& exact) {
  double worst = 0;
  for (int v = 0; v < body.model().vertices(); ++v) {
    const Eigen::Vector3d point = body.state().equilibrium.position.segment<3>(3 * v);
    const Eigen::Vector2d section(std::abs(point.x()), point.z());
    worst = std::max(worst, std::abs((section - exact.center).norm() - exact.radius));
  }
  return worst;
}

struct Pressed {
  double force;        // newton / metre
  double pressure;     // pascal
  double off_the_arc;  // metres
};

std::vector<Pressed> press(int triangles, double length, const std::vector<double>& depths) {
  Body body(fingerpad(length, triangles), {line_tool(2 * length)}, quasi_static());
  body.settle();
  std::vector<Pressed> results;
  ToolPose pose = pose_at({0, 0, kRadius + 0.1e-3});
  for (const double depth : depths) {
    pose = move(body, pose, {0, 0, kRadius - depth}, 4, 1);
    results.push_back({.force = body.state().contacts[0].force.z() / length,
                       .pressure = body.state().equilibrium.pressure[0],
                       .off_the_arc = off_the_arc(body, exact_section(depth))});
  }
  return results;
}

TEST(Fingerpad, ForcePerLengthPressureAndShapeAreThoseOfTheExactSolution) {
  const std::vector<double> depths = {1e-3, 2e-3, 3e-3, 4e-3};
  const std::vector<Pressed> pressed = press(2000, 10e-3, depths);
  std::printf("depth mm  force N/m   exact  error %%  pressure Pa  exact  off the arc um\n");
  for (std::size_t k = 0; k < depths.size(); ++k) {
    const ExactSection exact = exact_section(depths[k]);
    std::printf("%8.0f  %9.5f  %8.5f  %.3f  %9.4f  %9.4f  %.2f\n", 1e3 * depths[k], pressed[k].force, exact.force,
                100 * (pressed[k].force / exact.force - 1), pressed[k].pressure, exact.pressure,
                1e6 * pressed[k].off_the_arc);
    EXPECT_NEAR(pressed[k].force, exact.force, 0.01 * exact.force) << depths[k];
    EXPECT_NEAR(pressed[k].pressure, exact.pressure, 0.01 * exact.pressure) << depths[k];
    EXPECT_LT(pressed[k].off_the_arc, 10e-6) << depths[k];  // chords of 0.5 mm; 5e-6 seen
  }
}

TEST(Fingerpad, ErrorFallsWithTheSquareOfTheEdgeLength) {
  const double exact = exact_section(3e-3).force;
  std::array<double, 3> error{};
  for (int level = 0; level < 3; ++level) {
    error[level] = press(125 << (2 * level), 5e-3, {1e-3, 2e-3, 3e-3}).back().force / exact - 1;
    std::printf("%d triangles: error %.4f %%\n", 125 << (2 * level), 100 * error[level]);
  }
  EXPECT_GT(error[0] / error[1], 3);
  EXPECT_GT(error[1] / error[2], 3);
}

TEST(Fingerpad, StaysInPlaneStrainAndSymmetric) {
  Body body(fingerpad(5e-3, 500), {line_tool(10e-3)}, quasi_static());
  body.settle();
  move(body, pose_at({0, 0, kRadius + 0.1e-3}), {0, 0, kRadius - 3e-3}, 6, 1);
  const Eigen::VectorXd motion = body.state().equilibrium.position - body.model().rest_position;
  double along = 0;
  for (int v = 0; v < body.model().vertices(); ++v) along = std::max(along, std::abs(motion[3 * v + 1]));
  std::printf("largest motion along the axis: %.2e m\n", along);
  EXPECT_LT(along, 1e-6);  // none in the exact solution; the half triangles at the ends leave 6e-8
  EXPECT_LT(std::abs(body.state().contacts[0].force.x()), 1e-9 * body.state().contacts[0].force.z());
  EXPECT_LT(std::abs(body.state().contacts[0].force.y()), 1e-9 * body.state().contacts[0].force.z());
}

}  // namespace
}  // namespace thinwall
