// Implicit dynamics against motions that are known in closed form or by invariants.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

/// One free vertex in the middle of a stretched square of four triangles whose rim is held. A point tool pulls it out
/// of the plane and lets it go.
BodyDefinition drum() {
  SurfaceMesh mesh;
  mesh.vertices = {{0, 0, 0}, {10e-3, 10e-3, 0}, {-10e-3, 10e-3, 0}, {-10e-3, -10e-3, 0}, {10e-3, -10e-3, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  mesh.groups["rim"] = {1, 2, 3, 4};
  BodyDefinition body = make_body(mesh, 1e-3, neo_hookean(20e3));
  body.prestretch = {{.first = 1.2, .second = 1.2}};
  body.fluid.kind = FluidKind::kNone;
  body.fixed = {fixed_group("rim")};
  return body;
}

/// Angular frequency of small motions of the drum's centre across its plane. The area of a triangle of base b and
/// height a grows by b z^2 / (4 a) when its tip rises by z; b = 2 a, so four triangles under tension T store
/// 2 T z^2 and pull with 4 T z.
double drum_frequency(const Body& body) {
  const BodyModel& model = body.model();
  const double tension =
      largest_tension(model.rest[0], model.material(0), corners_of(model.surface[0], model.rest_position));
  return std::sqrt(4 * tension / model.mass[2]);
}

/// Heights of the centre after the tool has pushed it down by 0.02 mm along half a cosine and lets go, metres. The push
/// lasts a period, the observation `periods` more.
std::vector<double> drum_heights(int steps_per_period, int periods) {
  Body body(drum(), {point_tool()}, dynamic());
  body.settle();
  const double period = 2 * std::numbers::pi / drum_frequency(body), step = period / steps_per_period;
  constexpr double kDepth = 2e-5;
  std::vector<ToolPose> from = {pose_at({0, 0, 1e-9})}, to = from;
  for (int k = 1; k <= steps_per_period; ++k) {
    to[0].tip.z() = -0.5 * kDepth * (1 - std::cos(std::numbers::pi * k / steps_per_period));
    body.advance(from, to, step);
    from = to;
  }
  to[0].tip.z() = 1;
  std::vector<double> heights = {body.state().equilibrium.position[2]};
  EXPECT_FALSE(body.state().attachments.empty());
  for (int k = 1; k <= periods * steps_per_period; ++k) {
    body.advance(from, to, step);
    from = to;
    heights.push_back(body.state().equilibrium.position[2]);
  }
  EXPECT_TRUE(body.state().attachments.empty());
  return heights;
}

TEST(Dynamics, SingleVertexSwingsWithTheFrequencyOfItsTensionAndMass) {
  constexpr int kSteps = 200;
  const std::vector<double> heights = drum_heights(kSteps, 4);
  std::vector<double> crossings;  // in periods
  for (std::size_t k = 1; k < heights.size(); ++k) {
    if (heights[k - 1] < 0 && heights[k] >= 0) {
      crossings.push_back((static_cast<double>(k) - heights[k] / (heights[k] - heights[k - 1])) / kSteps);
    }
  }
  ASSERT_GE(crossings.size(), 3u);
  const double period = (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
  std::printf("period over the exact one: %.6f\n", period);
  // The second-order difference slows a motion down by (w h)^2 / 3 of its frequency, 3e-4 at 200 steps a period.
  EXPECT_NEAR(period, 1, 1e-3);
}

/// Position and velocity of all vertices at the end of a smooth breath of the fluid of 1 s,
/// slow beside the wall's own swings, which steps of this length would have to resolve otherwise.
Eigen::VectorXd after_a_breath(int steps) {
  Body body(pressurised_hemisphere(64, 300), {}, dynamic());
  body.settle();
  const double duration = 1, volume = body.state().fluid_volume[0];
  for (int k = 1; k <= steps; ++k) {
    const double rise = 0.5 * (1 - std::cos(1.5 * std::numbers::pi * k / steps));
    body.advance({}, {}, duration / steps, filling(body, volume * (1 + 0.1 * rise * rise)));
  }
  Eigen::VectorXd state(2 * body.state().velocity.size());
  state << body.state().equilibrium.position, body.state().velocity * (duration / (2 * std::numbers::pi));
  return state;
}

TEST(Dynamics, ErrorOfASmoothMotionFallsWithTheSquareOfTheStep) {
  // Against a run with steps so fine that its own error is a hundredth of the finest one compared.
  const Eigen::VectorXd reference = after_a_breath(1280);
  std::array<double, 3> error{};
  for (int level = 0; level < 3; ++level) {
    error[level] = (after_a_breath(40 << level) - reference).cwiseAbs().maxCoeff();
  }
  std::printf("errors: %.3e %.3e %.3e m\n", error[0], error[1], error[2]);
  EXPECT_NEAR(error[0] / error[1], 4, 0.8);  // seen 4.6
  EXPECT_NEAR(error[1] / error[2], 4, 0.9);  // seen 4.7: swings of the wall die away meanwhile
}

/// A free ball that a point has pushed and let go.
Body kicked_ball() {
  BodyDefinition definition = make_body(make_sphere(20e-3, 320), 1e-3, neo_hookean(20e3));
  definition.fluid.initial_pressure = 300;
  Body body(definition, {point_tool()}, dynamic());
  body.settle();
  ToolPose pose = move(body, pose_at({3e-3, 2e-3, 23e-3}), {3e-3, 2e-3, 18e-3}, 10, 2e-3);
  move(body, pose, {3e-3, 2e-3, 60e-3}, 10, 2e-3);
  EXPECT_TRUE(body.state().attachments.empty());
  return body;
}

TEST(Dynamics, ChangeOfMomentumIsTheForceOfTheToolOverTime) {
  // m a = sum of forces at each step; the difference formula of the velocity integrates it to second order.
  BodyDefinition definition = make_body(make_sphere(20e-3, 320), 1e-3, neo_hookean(20e3));
  definition.fluid.initial_pressure = 300;
  Body body(definition, {point_tool()}, dynamic());
  body.settle();
  move(body, pose_at({3e-3, 2e-3, 23e-3}), {3e-3, 2e-3, 18e-3}, 10, 2e-3, [&](const ToolPose&) {
    const Eigen::Vector3d force = -body.state().contacts[0].force;
    const Eigen::Vector3d rate = momentum_rate(body);
    EXPECT_LT((rate - force).norm(), 1e-8 * std::max(force.norm(), largest_single_force(body)));
  });
}

/// Mass times position of wall and fluid, kg metre.
Eigen::Vector3d mass_position(const Body& body) {
  const Eigen::Vector3d wall = mass_sum(body.model(), body.state().equilibrium.position);
  return wall + body.model().definition.fluid.density * body.state().fluid_motion[0].moment;
}

TEST(Dynamics, FreeFlightKeepsMomentum) {
  Body body = kicked_ball();
  const std::vector<ToolPose> away = {pose_at({0, 0, 1})};
  // The difference formula reaches two steps back: after 40 steps what it saw of the push has died away as 3^-40.
  for (int step = 0; step < 40; ++step) body.advance(away, away, 2e-3);
  const Eigen::Vector3d before = momentum(body);
  const Eigen::Vector3d start = mass_position(body);
  ASSERT_GT(before.norm(), 1e-4);
  for (int step = 0; step < 40; ++step) body.advance(away, away, 2e-3);
  const Eigen::Vector3d after = momentum(body);
  std::printf("relative change of momentum %.1e\n", (after - before).norm() / before.norm());
  EXPECT_LT((after - before).norm(), 1e-9 * before.norm());
  const Eigen::Vector3d way = mass_position(body) - start;
  EXPECT_LT((way - 40 * 2e-3 * before).norm(), 1e-8 * way.norm());
}

TEST(Dynamics, BodyAtRestStaysAtRest) {
  Body body(pressurised_hemisphere(256, 300), {}, dynamic());
  body.settle();
  const Eigen::VectorXd settled = body.state().equilibrium.position;
  for (int step = 0; step < 20; ++step) body.advance({}, {}, 5e-3);
  EXPECT_LT((body.state().equilibrium.position - settled).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LT(body.state().books.kinetic, 1e-12 * body.state().books.elastic);
}

TEST(Dynamics, SlowMotionIsQuasiStatic) {
  const auto pressed = [](Analysis analysis) {
    SimulationOptions options;
    options.analysis = analysis;
    Body body(pressurised_hemisphere(256, 300), {sphere_tool(5e-3)}, options);
    body.settle();
    move(body, pose_at({1e-3, 1e-3, 21e-3}), {1e-3, 1e-3, 17e-3}, 8, 10);  // half a minute per centimetre
    return body.state().contacts[0].force.z();
  };
  const double still = pressed(Analysis::kQuasiStatic);
  EXPECT_NEAR(pressed(Analysis::kDynamic), still, 1e-6 * still);
}

TEST(Dynamics, AShortStepEndsWhereOnlyRoundOffIsLeft) {
  BodyDefinition definition = make_body(make_sphere(20e-3, 320), 1e-3, neo_hookean(20e3));
  definition.fluid.initial_pressure = 1000;
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -12e-3}}};
  Body body(definition, {sphere_tool(5e-3)}, dynamic());
  body.settle();
  ToolPose pose = pose_at({0, 0, 24e-3});
  pose = move(body, pose, {0, 0, 18e-3}, 10, 0.01);
  // The springs of inertia are stiff by the square of the step: what the wall itself asks for is lost in their digits.
  for (const double step : {1e-6, 1e-7, 1e-8}) {
    move(body, pose, pose.tip, 4, step,
         [&](const ToolPose&) { EXPECT_LE(body.report().newton_iterations, 4) << step; });
  }
}

TEST(Dynamics, ABodyFarFromTheOriginMovesAsOneThatIsNear) {
  for (const FluidKind fluid : {FluidKind::kNone, FluidKind::kIncompressible}) {
    BodyDefinition definition = make_body(make_sphere(20e-3, 320), 1e-3, neo_hookean(50e3));
    definition.fluid.kind = fluid;
    if (fluid != FluidKind::kNone) definition.fluid.initial_pressure = 500;
    for (Eigen::Vector3d& vertex : definition.mesh.vertices) vertex += Eigen::Vector3d(3, -4, 2);
    SimulationOptions options = dynamic();
    options.gravity = {1, 0, -9.81};
    Body body(definition, {}, options);
    body.settle();
    for (int step = 0; step < 10; ++step) {
      body.advance({}, {}, 10e-3);
      // 5 are seen, and hundreds where forces are wanted to digits that the coordinates do not have.
      EXPECT_LE(body.report().newton_iterations, 10) << step;
    }
  }
}

// A free ball that a tool strikes gets all its velocity within a step, its near side most: were that to go on, it would
// be thrown through itself.
TEST(Dynamics, AWallThatHasJustBeenStruckBeginsTheNextStepWhereItMissesLeast) {
  constexpr double kStep = 2e-3, kSpeed = 60e-3;  // seconds, metres / second
  BodyDefinition definition = make_body(make_sphere(20e-3, 320), 1e-3, neo_hookean(20e3));
  definition.fluid.initial_pressure = 300;
  Body body(definition, {sphere_tool(6e-3)}, dynamic());
  body.settle();
  ToolPose at = pose_at({0, 0, 20.05e-3});
  std::vector<int> iterations;
  for (int step = 0; step < 2; ++step) {
    const std::vector<ToolPose> from = {at};
    at.tip.z() -= kSpeed * kStep;
    body.advance(from, std::vector{at}, kStep);
    iterations.push_back(body.report().newton_iterations);
  }
  // 5 are seen, and 40 where the wall begins as if it went on.
  EXPECT_LT(iterations[1], 15);
}

}  // namespace
}  // namespace thinwall
