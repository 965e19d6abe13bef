// The fluid of a body at rest: compressible contents, the pressure that a script asks for, and what a wall cannot hold.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kRadius = 20e-3, kThickness = 1e-3, kModulus = 20e3;

BodyDefinition ball(FluidKind kind, std::optional<double> pressure) {
  BodyDefinition body = make_body(make_sphere(kRadius, 1280), kThickness, neo_hookean(kModulus));
  body.fluid.kind = kind;
  body.fluid.bulk_modulus = 40e3;
  body.fluid.initial_pressure = pressure;
  return body;
}

/// Pressure of a neo-Hookean balloon at a stretch.
double balloon_pressure(double stretch) {
  return 2 * kModulus * kThickness / kRadius * (1 / stretch - std::pow(stretch, -7));
}

double stretch_of(const Body& body) {
  return std::cbrt(body.state().volume[0] / body.model().rest_volume);
}

TEST(FluidBody, WithoutPressureKeepsTheVolumeOfTheMeshAndNoPressure) {
  for (const FluidKind kind : {FluidKind::kIncompressible, FluidKind::kCompressible}) {
    Body body(ball(kind, std::nullopt), {}, quasi_static());
    body.settle();
    EXPECT_NEAR(body.state().volume[0], body.model().rest_volume, 1e-12 * body.model().rest_volume);
    EXPECT_NEAR(body.state().equilibrium.pressure[0], 0, 1e-6);
    EXPECT_LT((body.state().equilibrium.position - body.model().rest_position).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(FluidBody, InitialPressureFindsTheStretchThatHoldsIt) {
  for (const FluidKind kind : {FluidKind::kIncompressible, FluidKind::kCompressible}) {
    for (const double pressure : {100.0, 800.0, 1150.0}) {  // the limit point is at 1240 Pa
      Body body(ball(kind, pressure), {}, quasi_static());
      body.settle();
      EXPECT_NEAR(body.state().equilibrium.pressure[0], pressure, 1e-9 * pressure);
      // The polyhedron holds 0.4 % more than the sphere at the same stretch, as in the test of inflation.
      EXPECT_NEAR(balloon_pressure(stretch_of(body)), pressure, 5e-3 * pressure);
      EXPECT_EQ(body.state().fluid_volume[0], body.state().volume[0]);
      EXPECT_LT(internal_forces(body).cwiseAbs().maxCoeff(), 1e-8 * largest_single_force(body));
    }
  }
}

TEST(FluidBody, InflatesATubeWithFreeEndsEvenly) {
  // A tube of one stretch around and one along, of which the caps at both ends bear the pressure to the rims.
  const double radius = 10e-3, length = 60e-3, modulus = 50e3, thickness = 0.5e-3, pressure = 1200;
  // 1.6e-4 and 2e-5 are left, as vertices of a rim have two triangles and three by turns.
  for (const auto& [triangles, tolerance] : {std::pair(600, 3e-4), std::pair(2400, 4e-5)}) {
    SCOPED_TRACE(triangles);
    BodyDefinition definition = make_body(make_cylinder(radius, length, triangles), thickness, neo_hookean(modulus));
    const std::vector<int> ends = definition.mesh.groups.at("ends");
    definition.fluid.initial_pressure = pressure;
    Body body(std::move(definition), {}, quasi_static());
    body.settle();
    const Eigen::VectorXd& now = body.state().equilibrium.position;
    double least = 1e9, most = 0, along = 0;
    for (const int v : ends) {
      const double stretch = 2 * std::abs(now[3 * v + 1]) / length;
      least = std::min(least, stretch);
      most = std::max(most, stretch);
      along += stretch / static_cast<double>(ends.size());
    }
    const double around = std::sqrt(body.state().volume[0] / body.model().rest_volume / along);
    // Pressure times area of the cross-section over thickness times perimeter, of a regular polygon at rest.
    const double turn = 2 * std::numbers::pi / (static_cast<double>(ends.size()) / 2);
    const double stress = pressure * radius * std::cos(turn / 2) / (2 * thickness);
    const double squared = along * around * along * around;
    EXPECT_NEAR(modulus * (around - 1 / (squared * around)), 2 * stress * around * along, 2 * tolerance * stress);
    EXPECT_NEAR(modulus * (along - 1 / (squared * along)), stress * around * around, tolerance * stress);
    EXPECT_NEAR(most, least, tolerance) << "ends stay flat";
  }
}

TEST(FluidBody, NegativePressureBelowWhatTheWallBearsSettlesOnASupportedBody) {
  Body body(pressurised_hemisphere(256, 0), {}, quasi_static());
  body.settle();
  EXPECT_NEAR(body.state().volume[0], body.model().rest_volume, 1e-9 * body.model().rest_volume);
}

TEST(FluidBody, PressureBeyondTheLimitPointIsRefusedWithWords) {
  BodyDefinition definition = make_body(make_sphere(kRadius, 80), kThickness, neo_hookean(kModulus));
  definition.fluid.initial_pressure = 2000;
  Body body(definition, {}, quasi_static());
  try {
    body.settle();
    FAIL() << "settled at a stretch of " << stretch_of(body);
  } catch (const SimulationFailure& failure) {
    const std::string words = failure.what();
    EXPECT_NE(words.find("`body`"), std::string::npos) << words;
    EXPECT_NE(words.find("2000 Pa"), std::string::npos) << words;
    EXPECT_NE(words.find("take a lower pressure, or a thicker or stiffer wall"), std::string::npos) << words;
  }
}

TEST(FluidBody, CompressibleFluidFollowsItsLawWhenPressedAndFilled) {
  // p = p0 + kappa (Vf - V) / Vf, to the tolerance of the volume's equation.
  BodyDefinition definition = pressurised_hemisphere(256, 300);
  definition.fluid.kind = FluidKind::kCompressible;
  definition.fluid.bulk_modulus = 40e3;
  Body body(definition, {sphere_tool(5e-3)}, quasi_static());
  body.settle();
  const auto expect_law = [&](const char* when) {
    const BodyState& state = body.state();
    const double law = 300 + 40e3 * (state.fluid_volume[0] - state.volume[0]) / state.fluid_volume[0];
    EXPECT_NEAR(state.equilibrium.pressure[0], law, 1e-5) << when;
  };
  expect_law("settled");
  const ToolPose pose = move(body, pose_at({0, 0, 22e-3}), {0, 0, 15e-3}, 5, 1);
  expect_law("pressed");
  EXPECT_LT(body.state().volume[0], body.state().fluid_volume[0] * 0.9999);
  EXPECT_GT(body.state().equilibrium.pressure[0], 310);
  const double before = body.state().books.script_work;
  body.advance({&pose, 1}, {&pose, 1}, 1, filling(body, 1.05 * body.state().fluid_volume[0]));
  EXPECT_GT(body.state().books.script_work, before);
  expect_law("filled");
  EXPECT_NEAR(body.state().books.imbalance(), 0, 1e-12);
}

TEST(FluidBody, StiffCompressibleFluidIsNearlyIncompressible) {
  const auto pressed = [](FluidKind kind) {
    BodyDefinition definition = pressurised_hemisphere(256, 300);
    definition.fluid.kind = kind;
    definition.fluid.bulk_modulus = 2e9;
    Body body(definition, {point_tool()}, quasi_static());
    body.settle();
    move(body, pose_at({1e-4, 2e-4, 22e-3}), {1e-4, 2e-4, 16e-3}, 6, 1);
    return body.state().contacts[0].force.z();
  };
  const double stiff = pressed(FluidKind::kCompressible), rigid = pressed(FluidKind::kIncompressible);
  // 100 Pa of 2 GPa squeeze the fluid by 5e-8; residual seen 1e-6.
  EXPECT_NEAR(stiff, rigid, 1e-4 * rigid);
}

TEST(FluidBody, WithoutFluidTheWallAloneResists) {
  BodyDefinition sheet = make_body(make_disc(20e-3, 600), 1e-3, neo_hookean(20e3));
  sheet.fluid.kind = FluidKind::kNone;
  sheet.prestretch = {{.first = 1.1, .second = 1.1}};
  sheet.fixed = {{.region = BoundaryRegion{}}};
  Body body(sheet, {sphere_tool(8e-3)}, quasi_static());
  body.settle();
  EXPECT_EQ(body.state().equilibrium.pressure.size(), 0);
  EXPECT_EQ(body.state().volume.size(), 0);
  move(body, pose_at({0, 0, 1e-3}), {0, 0, -4e-3}, 5, 1);
  EXPECT_GT(body.state().contacts[0].force.z(), 0.05);
  EXPECT_LT((support_force(body) - body.state().contacts[0].force).norm(), 1e-8 * body.state().contacts[0].force.z());
}

}  // namespace
}  // namespace thinwall
