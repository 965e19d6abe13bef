// Tools of every shape pressed into a body: what they do to the wall and the wall to them.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/contact/TriangleCrossing.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

std::vector<ToolDefinition> solid_tools() {
  ToolDefinition capsule = sphere_tool(2e-3);
  capsule.kind = ToolKind::kCapsule;
  capsule.name = "capsule";
  capsule.length = 12e-3;
  ToolDefinition plate{.name = "plate", .kind = ToolKind::kPlate, .length = 10e-3, .width = 8e-3, .thickness = 2e-3};
  ToolDefinition needle{.name = "needle", .kind = ToolKind::kNeedle, .length = 30e-3, .radius = 0.5e-3};
  ToolDefinition blade{
      .name = "blade", .kind = ToolKind::kScalpel, .length = 20e-3, .width = 6e-3, .thickness = 0.4e-3};
  ToolDefinition forceps{.name = "forceps",
                         .kind = ToolKind::kForceps,
                         .length = 30e-3,
                         .width = 4e-3,
                         .thickness = 1.5e-3,
                         .opening = 8e-3};
  return {sphere_tool(4e-3), capsule, plate, needle, blade, forceps};
}

ToolPose slanted_pose(const ToolDefinition& tool, const Eigen::Vector3d& tip) {
  ToolPose pose = pose_at(tip, Eigen::Vector3d(0.12, -0.08, -1).normalized());
  const Eigen::AngleAxisd turn(0.3, pose.direction);
  pose.axis = turn * pose.axis;
  pose.opening = tool.opening;
  return pose;
}

/// Signed distance of the deepest vertex and of the deepest point of all triangles, metres.
std::array<double, 2> deepest(const Body& body, const ToolDefinition& tool, const ToolPose& pose) {
  std::array<double, 2> least = {1, 1};
  for (const ToolSolid& solid : tool_solids(tool, pose)) {
    for (int t = 0; t < body.model().triangles(); ++t) {
      const auto corners = corners_of(body.model().surface[t], body.state().equilibrium.position);
      for (int k = 0; k < 3; ++k) least[0] = std::min(least[0], signed_distance(solid, corners[k]).value);
      least[1] = std::min(least[1], solid_gap(solid, 1, corners, SitePart::kFace)->gap);
    }
  }
  return least;
}

TEST(SolidTools, OfEveryKindKeepTheWallOutAndFeelWhatTheSupportsHold) {
  for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
    for (const ToolDefinition& tool : solid_tools()) {
      SimulationOptions options;
      options.analysis = analysis;
      Body body(pressurised_hemisphere(1024, 300), {tool}, options);
      body.settle();
      const ToolPose pose = slanted_pose(tool, {1e-3, 0.5e-3, 21.9e-3});
      double sharpness = 1;
      for (const ToolSolid& solid : tool_solids(tool, pose)) sharpness = std::min(sharpness, solid.sharpness());
      int iterations = 0, halvings = 0;
      std::array<double, 2> nearest = {1, 1};
      move(body, pose, pose.tip + 4.5e-3 * pose.direction, 24, 20e-3, [&](const ToolPose& now) {
        iterations += body.report().newton_iterations;
        halvings += body.report().halvings;
        const auto depths = deepest(body, tool, now);
        for (int k = 0; k < 2; ++k) nearest[k] = std::min(nearest[k], depths[k]);
        if (body.state().contacts[0].touching) {
          EXPECT_LE(depths[1], 10e-6) << tool.name;
        }
      });
      const ToolContact& contact = body.state().contacts[0];
      std::printf(
          "%s%s: %.1f iterations a step, %d halvings, %.4f N, %.2f mm^2, vertices from %.3f um, faces %.2f um\n",
          tool.name.c_str(), analysis == Analysis::kDynamic ? ", dynamic" : "", iterations / 24.0, halvings,
          contact.force.norm(), 1e6 * contact.area, 1e6 * nearest[0], 1e6 * nearest[1]);
      EXPECT_GT(nearest[0], 0) << tool.name;
      EXPECT_GT(nearest[1], -0.0301 * sharpness) << tool.name;
      EXPECT_GT(contact.force.norm(), 0.02) << tool.name;
      EXPECT_LE(halvings, 10) << tool.name;
      if (analysis == Analysis::kQuasiStatic) {
        const Eigen::Vector3d rest = support_force(body) - contact.force;
        EXPECT_LT(rest.norm(), 1e-8 * contact.force.norm()) << tool.name;
      }
    }
  }
}

TEST(SolidTools, OfEveryKindThatRubKeepBalanceAndBooks) {
  for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
    for (ToolDefinition tool : solid_tools()) {
      tool.friction = 0.5;
      SimulationOptions options;
      options.analysis = analysis;
      Body body(pressurised_hemisphere(1024, 600), {tool}, options);
      body.settle();
      ToolPose pose = slanted_pose(tool, {1e-3, 0.5e-3, 24e-3});
      int halvings = 0;
      const auto note = [&](const ToolPose&) { halvings += body.report().halvings; };
      pose = move(body, pose, pose.tip + 4e-3 * pose.direction, 16, 20e-3, note);
      const Eigen::Vector3d side(0.8, 0.6, 0);
      const Eigen::Vector3d pressed = body.state().contacts[0].force;
      pose = move(body, pose, pose.tip + 1e-3 * side, 6, 20e-3, note);
      const Eigen::Vector3d force = body.state().contacts[0].force;
      const EnergyBooks& books = body.state().books;
      std::printf("%s%s: %d halvings, held back by %.4f of %.4f N, friction %.1e of %.1e J, numerical %.1e\n",
                  tool.name.c_str(), analysis == Analysis::kDynamic ? ", dynamic" : "", halvings,
                  (pressed - force).dot(side), force.norm(), books.friction, books.tool_work, books.numerical);
      EXPECT_GT((pressed - force).dot(side), 0.1 * force.norm()) << tool.name;
      EXPECT_GT(books.friction, 0) << tool.name;
      EXPECT_LT(std::abs(books.imbalance()), 1e-9 * books.tool_work) << tool.name;
      EXPECT_LE(halvings, 10) << tool.name;
      if (analysis == Analysis::kQuasiStatic) {
        EXPECT_LT((support_force(body) - force).norm(), 1e-8 * force.norm()) << tool.name;
      }
    }
  }
}

TEST(SolidTools, ThatBarelyTouchAFlatSlackWallAreFoundToTheLastBits) {
  // Beneath a plate that dents an unstretched sheet by some hundredths of a millimetre the vertices within its rims
  // bear next to nothing. One that wants to leave by less than its coordinates resolve was held and pushed, and the
  // share of the residual that it had stayed for ever: the first of these took 8 000 iterations, the second failed
  // after 40 000.
  SurfaceMesh mesh = make_sheet(38.9145e-3, 50.7587e-3, 250);
  const Eigen::Vector3d place(-46.94e-3, 14.0785e-3, -11.9819e-3);
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex += place;
  BodyDefinition sheet = make_body(mesh, 0.902076e-3, neo_hookean(8390.82));
  sheet.fluid.kind = FluidKind::kNone;
  sheet.fixed = {{.region = BoundaryRegion{}}};
  const ToolDefinition plate{
      .name = "plate", .kind = ToolKind::kPlate, .length = 14.2948e-3, .width = 18.3254e-3, .thickness = 2.91224e-3};
  const Eigen::Vector3d touch(-44.1461e-3, 6.97293e-3, place.z());
  for (const double dent : {0.0345e-3, 0.0419e-3, 0.0493e-3, 0.0567e-3, 0.0641e-3}) {
    Body body(sheet, {plate}, quasi_static());
    body.settle();
    ToolPose pose = pose_at(touch + Eigen::Vector3d(0, 0, 0.69e-3));
    pose.axis = Eigen::Vector3d(-0.731454, -0.915343, 0).normalized();
    move(body, pose, touch - Eigen::Vector3d(0, 0, dent), 1, 0.04);
    // Two solutions, one with pseudo-inertia, take some hundred.
    EXPECT_LT(body.report().newton_iterations, 1000) << dent;
    EXPECT_GT(body.state().contacts[0].force.z(), 0) << dent;
  }
}

/// What jaws that close over a filled ball of 20 mm, `aside` off its middle, squeeze it with, newton.
double squeeze_of(double aside) {
  BodyDefinition ball = make_body(make_sphere(20e-3, 320), 1e-3, mooney_rivlin(8e3, 2e3));
  ball.fluid.initial_pressure = 300;
  ball.fixed = {{.region = BelowRegion{.axis = 2, .at = -12e-3}}};
  const ToolDefinition jaws{
      .name = "jaws", .kind = ToolKind::kForceps, .length = 30e-3, .width = 16e-3, .thickness = 3e-3, .opening = 50e-3};
  Body body(ball, {jaws}, quasi_static());
  body.settle();
  std::array<ToolPose, 1> from = {pose_at({aside, 0, -8e-3})}, to = from;
  from[0].opening = jaws.opening;
  constexpr double kClosed = 39e-3;  // metres
  constexpr int kSteps = 10;
  for (int step = 1; step <= kSteps; ++step) {
    to[0].opening = jaws.opening + (kClosed - jaws.opening) * step / kSteps;
    body.advance(from, to, 0.1);
    from = to;
  }
  EXPECT_GT(body.state().contacts[0].area, 0) << "a jaw touches";
  return body.squeeze(0, to[0]);
}

TEST(SolidTools, JawsSqueezeWithTheForceOfTheOneThatFeelsLess) {
  const double even = squeeze_of(0), uneven = squeeze_of(0.3e-3), one_sided = squeeze_of(3e-3);
  std::printf("%.4f N in the middle, %.4f N beside it, %.4f N with one jaw\n", even, uneven, one_sided);
  EXPECT_GT(even, 0.005) << "300 Pa on some 30 mm^2 and more";
  EXPECT_LT(uneven, even);
  EXPECT_EQ(one_sided, 0);
}

/// What a tool feels that waits over a ball of 20 mm until that is filled beyond it, newton. `height`: metres.
double force_of_growth(const ToolDefinition& tool, double height, int steps) {
  BodyDefinition ball = make_body(make_sphere(20e-3, 1280), 0.5e-3, mooney_rivlin(40e3, 6e3));
  ball.fluid.initial_pressure = 300;
  ball.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};
  Body body(ball, {tool}, quasi_static());
  body.settle();
  const ToolPose waiting = pose_at({0, 0, height});
  const double from = body.state().fluid_volume[0], full = 60e-6;  // metres^3
  for (int step = 1; step <= steps; ++step) {
    body.advance({&waiting, 1}, {&waiting, 1}, 0.1, filling(body, from + (full - from) * step / steps));
  }
  return body.state().contacts[0].force.norm();
}

TEST(SolidTools, BallsRodsAndPlatesAreNotPassedByAWallThatGrowsBeyondThemInOneStep) {
  for (const ToolDefinition& tool : solid_tools()) {
    const bool is_plate = tool.kind == ToolKind::kPlate;
    if (tool.kind != ToolKind::kSphere && tool.kind != ToolKind::kCapsule && !is_plate) continue;
    for (const double height : {22e-3, 26e-3}) {
      const double at_once = force_of_growth(tool, height, 1), slowly = force_of_growth(tool, height, 10);
      std::printf("%s at %.0f mm: %.6f N at once, %.1e of it off slowly\n", tool.name.c_str(), 1e3 * height, at_once,
                  std::abs(at_once - slowly) / slowly);
      EXPECT_GT(slowly, 0.1);
      // Round tools feel the same equilibrium, 3e-9 apart by what the solver leaves. Edges that have come over a
      // plate's rim in one go may stay in it: 3 % of the force.
      EXPECT_NEAR(at_once, slowly, (is_plate ? 0.05 : 1e-6) * slowly) << tool.name;
    }
  }
}

/// Whether the wall has closed around a needle's shaft, so that one of its triangles is run through.
bool runs_through(const Body& body, const ToolDefinition& needle, const ToolPose& pose) {
  const Eigen::Vector3d point = pose.tip - needle.radius * pose.direction,
                        end = pose.tip - needle.length * pose.direction;
  return std::ranges::any_of(body.model().surface, [&](const Eigen::Vector3i& triangle) {
    const auto corners = corners_of(triangle, body.state().equilibrium.position);
    return goes_through(point, end, {.from = corners, .to = corners});
  });
}

// Oblique to a slack ball of coarse triangles. Run through, the needle was pulled at with 1.27 N when it was back
// outside, 4.5 times of what it had felt in its depth.
TEST(SolidTools, ANeedleIsNotRunIntoAWallThatSnapsOffItsPoint) {
  const ToolDefinition needle{.name = "needle", .kind = ToolKind::kNeedle, .length = 120e-3, .radius = 0.8e-3};
  SimulationOptions options = quasi_static();
  options.tolerance = 1e-4;
  BodyDefinition ball = make_body(make_sphere(40e-3, 320), 2e-3, neo_hookean(15e3));
  ball.fluid.initial_pressure = 100;
  Body body(ball, {needle}, options);
  body.settle();
  constexpr double kStep = 1.3333e-3;
  constexpr int kWayIn = 19;
  const auto pose_after = [](int steps) { return pose_at({20e-3, 3e-3, 39.576e-3 - steps * kStep}); };
  double largest = 0;
  for (int step = 1; step <= 2 * kWayIn; ++step) {
    const ToolPose begin = pose_after(kWayIn - std::abs(kWayIn - step + 1)),
                   end = pose_after(kWayIn - std::abs(kWayIn - step));
    body.advance({&begin, 1}, {&end, 1}, 33e-3);
    largest = std::max(largest, body.state().contacts[0].force.norm());
    EXPECT_FALSE(runs_through(body, needle, end)) << "step " << step;
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_EQ(body.state().contacts[0].force.norm(), 0) << "back outside";
}

}  // namespace
}  // namespace thinwall
