// Bodies with openings that spring back: the air that comes in, and goes out before the fluid.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/equilibrium/OpenChambers.hpp"
#include "tests/engine/simulation/LeakWatch.hpp"
#include "tests/engine/simulation/OpenBodies.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

/// A shell that springs back without pressure, pressed from the side and let go.
BodyDefinition springy_ball() {
  BodyDefinition definition = open_ball(320, 100);
  definition.model = WallModel::kShell;
  definition.thickness.assign(definition.thickness.size(), 2e-3);
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};
  return definition;
}

TEST(AirInAnOpenBody, ComesInWhenTheWallSpringsBackAndGoesOutFreely) {
  Body body(springy_ball(), {sphere_tool(6e-3)}, quasi_static());
  body.settle();
  LeakWatch watch(body);
  const auto note = [&](const ToolPose&) { watch.note(body); };
  const Eigen::Vector3d far(28e-3, 0, 0), deep(10e-3, 0, 0);
  ToolPose pose = pose_at(far, -Eigen::Vector3d::UnitX());
  pose = move(body, pose, deep, 20, 0.01, note);
  pose = move(body, pose, deep, 20, 0.02, note);
  const double pressed_out = body.state().leaked[0];
  EXPECT_GT(pressed_out, 1e-6);
  EXPECT_EQ(watch.most_air, 0);
  pose = move(body, pose, far, 20, 0.01, note);
  const double air = body.state().air[0];
  EXPECT_GT(air, 1e-6);
  EXPECT_NEAR(body.state().equilibrium.pressure[0], 0, 1e-9);
  // Half way there is still air inside, and no fluid leaves.
  pose = move(body, pose, 0.5 * (far + deep), 10, 0.02, note);
  EXPECT_EQ(body.state().leaked[0], pressed_out);
  EXPECT_LT(body.state().air[0], air);
  pose = move(body, pose, deep - Eigen::Vector3d(4e-3, 0, 0), 20, 0.01, note);
  EXPECT_EQ(body.state().air[0], 0);
  EXPECT_GT(body.state().equilibrium.pressure[0], 10);
  EXPECT_GT(body.state().leaked[0], pressed_out);
  watch.expect_sound();
}

TEST(AirInAnOpenBody, TakesTurnsWithPressureInMotionToo) {
  Body body(springy_ball(), {sphere_tool(6e-3)}, dynamic());
  body.settle();
  LeakWatch watch(body);
  const auto note = [&](const ToolPose&) { watch.note(body); };
  const Eigen::Vector3d far(28e-3, 0, 0), deep(10e-3, 0, 0);
  ToolPose pose = move(body, pose_at(far, -Eigen::Vector3d::UnitX()), deep, 20, 0.01, note);
  pose = move(body, pose, far, 20, 0.005, note);
  EXPECT_GT(body.state().air[0], 0.5e-6);
  watch.expect_sound();
}

TEST(AirInAnOpenBody, LiesAboveTheFluidUnderGravityAndTheBooksClose) {
  // A shell pressed and let go.
  BodyDefinition definition = springy_ball();
  SimulationOptions options = quasi_static();
  options.gravity = {0, 0, -9.81};
  Body body(definition, {sphere_tool(6e-3)}, options);
  body.settle();
  LeakWatch watch(body);
  const Eigen::Vector3d far(32e-3, 0, 0), deep(10e-3, 0, 0);
  const auto note = [&](const ToolPose&) {
    watch.note(body);
    watch.lowest_pressure = 0;  // that at the level, which the surface may be below
    watch.both = false;
  };
  const ToolPose pose = move(body, pose_at(far, -Eigen::Vector3d::UnitX()), deep, 20, 0.02, note);
  move(body, pose, far, 20, 0.02, note);
  EXPECT_GT(body.state().air[0], 1e-7);
  watch.expect_sound();
  const double surface = body.model().chambers[0].level.z() + body.state().equilibrium.pressure[0] / (1010 * 9.81);
  EXPECT_LT(surface, lip_cap_of(body.model().openings[0].at(body.state().equilibrium.position)).center.z());
  std::printf("numerical %.1e, leak %.1e J\n", body.state().books.numerical, body.state().books.leak);
}

/// Stiff enough to stand up while its contents are drawn off; the lips at the top are 19 mm above the level, and the
/// fluid stands 20 Pa above them.
BodyDefinition ball_of_soft_fluid() {
  BodyDefinition definition = springy_ball();
  fix_lips(definition);
  definition.materials = {neo_hookean(200e3)};
  definition.fluid.kind = FluidKind::kCompressible;
  definition.fluid.bulk_modulus = 20e3;
  definition.fluid.initial_pressure = 210;
  return definition;
}

SimulationOptions heavy(SimulationOptions options) {
  options.gravity = {0, 0, -9.81};
  return options;
}

/// Space that the fluid below the air fills, metres^3: beside air it is under the pressure at the level, or none.
double filled_by_fluid(const BodyState& state) {
  const double pressure = std::max(0.0, state.equilibrium.pressure[0]);
  return state.fluid_volume[0] * (1 - (pressure - 210) / 20e3);
}

TEST(AirAboveACompressibleFluid, ComesInWithoutAJumpHoweverShortTheStep) {
  for (const double step : {5e-3, 2.5e-3, 1.25e-3}) {
    Body body(ball_of_soft_fluid(), {}, heavy(dynamic()));
    body.settle();
    double largest_fall = 0, most_kinetic = 0, worst_imbalance = 0, before = 210;
    for (int k = 0; (k + 0.5) * step < 0.1; ++k) {
      const double drawn = 200e-6 * (k + 0.5) * step * step;
      body.advance({}, {}, step, {.load_factors = {}, .fluids = {{.added = -drawn, .pressure = {}}}});
      const double pressure = body.state().equilibrium.pressure[0];
      largest_fall = std::max(largest_fall, std::abs(pressure - before));
      most_kinetic = std::max(most_kinetic, body.state().books.kinetic);
      worst_imbalance = std::max(worst_imbalance, std::abs(body.state().books.imbalance()));
      before = pressure;
    }
    // Air in place of nearly all that was drawn off, a millilitre.
    EXPECT_NEAR(body.state().air[0], 0.93e-6, 0.02e-6);
    EXPECT_LT(largest_fall, 20);
    EXPECT_LT(most_kinetic, 2e-8);
    EXPECT_LT(worst_imbalance, 1e-15);
    EXPECT_LT(std::abs(body.state().books.numerical), 1e-7);
  }
}

TEST(AirAboveACompressibleFluid, LeavesItAsDenseAsThePressureMakesItDownToNone) {
  Body body(ball_of_soft_fluid(), {}, heavy(quasi_static()));
  body.settle();
  double worst = 0;
  bool above_level = false, below_level = false;
  for (int step = 0; step < 24; ++step) {
    body.advance({}, {}, 1, {.load_factors = {}, .fluids = {{.added = -1e-6, .pressure = {}}}});
    const BodyState& state = body.state();
    if (state.air[0] == 0) continue;
    (state.equilibrium.pressure[0] > 0 ? above_level : below_level) = true;
    worst = std::max(worst, std::abs(state.volume[0] - state.air[0] - filled_by_fluid(state)));
    EXPECT_LT(std::abs(state.books.imbalance()), 1e-12);
  }
  EXPECT_TRUE(above_level);
  EXPECT_TRUE(below_level);
  EXPECT_LT(worst, 1e-14);
}

TEST(AirInAnOpenBody, LetsFluidOutBelowItsSurfaceWithoutAJumpHoweverFastItComesToTheLips) {
  Body body(open_ball(320, 0, 2), {}, dynamic());
  EquilibriumProblem problem;
  problem.fluids = {{.has_surface = true}};
  problem.gravity = {0, 0, -9.81};
  problem.approach = {0.5};
  const double area = 1e-4, whole = 0.5 * area;  // metres^2, and metres^3 / second: all that comes leaves
  const auto at = [&](double pressure) { return outflow(body.model(), problem, 0, area, pressure); };
  const double full = 1010 * 9.81 * 0.5 * body.model().edge_length;  // pascal
  EXPECT_EQ(at(-1).rate, 0);
  EXPECT_EQ(at(0).rate, 0);
  EXPECT_LT(at(1e-6 * full).rate, 1e-4 * whole);
  EXPECT_GE(at(full).rate, whole);
  for (const double part : {0.1, 0.5, 0.9, 1.5}) {
    const double pressure = part * full, change = 1e-5 * full;
    const double slope = (at(pressure + change).rate - at(pressure - change).rate) / (2 * change);
    EXPECT_NEAR(at(pressure).slope, slope, 1e-8 * slope);
  }
  problem.approach = {0};
  EXPECT_EQ(at(0.5 * full).rate, orifice_flow(0.61, area, 1010, 0.5 * full).rate);
}

}  // namespace
}  // namespace thinwall
