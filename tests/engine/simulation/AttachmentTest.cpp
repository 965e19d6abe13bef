#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "engine/mesh/Shapes.hpp"
#include "engine/simulation/PrescribedPoint.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

/// A tube along y whose ends are held, under a little pressure.
BodyDefinition tube() {
  BodyDefinition body = make_body(make_cylinder(0.01, 0.04, 500), 1e-3, neo_hookean(20e3));
  body.fixed = {fixed_group("ends")};
  body.fluid.initial_pressure = 500;
  return body;
}

TEST(Attachment, ALineLaidAcrossHeldEndsPressesWhatIsFree) {
  Body body(tube(), {line_tool(0.042)}, quasi_static());
  body.settle();
  const ToolPose above = pose_at({0, 0, 0.014});
  const ToolPose down = move(body, above, {0, 0, 0.008}, 12, 0.02);
  EXPECT_GT(body.state().contacts[0].force.z(), 0);
  for (int v = 0; v < body.model().vertices(); ++v) {
    if (!body.model().fixed[3 * v + 2]) continue;
    EXPECT_EQ(body.state().equilibrium.position[3 * v + 2], body.model().rest_position[3 * v + 2])
        << "held vertex " << v;
  }
  move(body, down, above.tip, 12, 0.02);
  EXPECT_EQ(body.state().contacts[0].force.norm(), 0);
}

TEST(Attachment, ALineTakesTheFreeCornersOfATriangleThatIsHeldInPartAlong) {
  // Held in a ring about the place that is pressed, the line crosses triangles with few or no free corners.
  BodyDefinition ball = make_body(make_sphere(0.0167, 320), 4e-4, neo_hookean(44e3));
  ball.fixed = {{.region = BelowRegion{.axis = 2, .at = -0.0055}}};
  ball.fluid.initial_pressure = 240;
  Body body(ball, {line_tool(0.0133)}, quasi_static());
  body.settle();
  const Eigen::Vector3d rim(-0.0157, 0.0, -0.0058);
  ToolPose beside = pose_at(rim + Eigen::Vector3d(-1e-3, 0, 0));
  beside.direction = Eigen::Vector3d::UnitX();
  const ToolPose in = move(body, beside, rim + Eigen::Vector3d(2e-3, 0, 0), 12, 0.02);
  ASSERT_FALSE(body.state().attachments.empty());
  double least = 1;
  for (const Attachment& attachment : body.state().attachments) {
    const double share = free_share(body.model(), attachment).x();
    const Eigen::Vector3d way = holding_point(attachment, in) - attachment.touched;
    const Eigen::Vector3d gone = material_point(attachment, body.state().equilibrium.position) - attachment.touched;
    // As near as the solver closes gaps: 4.6e-9 seen.
    EXPECT_NEAR(gone.x(), share * way.x(), 2e-8);
    least = std::min(least, share);
  }
  EXPECT_LT(least, 0.5);
}

TEST(Attachment, APointPressedOnAHeldPointIsRefusedWithWords) {
  BodyDefinition held = tube();
  held.fixed.push_back({.region = AboveRegion{.axis = 2, .at = 0}});
  held.name = "tube";
  Body body(held, {point_tool()}, quasi_static());
  body.settle();
  try {
    move(body, pose_at({0, 0, 0.014}), {0, 0, 0.008}, 6, 0.02);
    FAIL() << "no failure";
  } catch (const SimulationFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("presses on a point of body `tube` that `fixed` holds"),
              std::string::npos)
        << failure.what();
  }
}

TEST(Attachment, AWallThatSpringsBackOverAPointIsHeldByIt) {
  Body body(pressurised_hemisphere(256, 400), {point_tool()}, dynamic());
  body.settle();
  const double top = 0.020;
  const ToolPose pressed = move(body, pose_at({0, 0, top + 1e-3}), {0, 0, top - 5e-3}, 12, 0.01);
  // Faster back than the wall can follow, and then no farther.
  const ToolPose waiting = move(body, pressed, {0, 0, top - 3e-3}, 1, 1e-3);
  EXPECT_FALSE(body.state().contacts[0].touching);
  move(body, waiting, waiting.tip, 200, 1e-3);
  EXPECT_TRUE(body.state().contacts[0].touching);
  EXPECT_GT(body.state().contacts[0].force.z(), 0);
}

TEST(Attachment, ALineTakesNoHoldOfAWallThatWasNeverInItsWay) {
  Body body(tube(), {line_tool(0.02)}, quasi_static());
  body.settle();
  // Set under the crown, then moved on by less than it lies under it.
  const ToolPose inside = pose_at({0, 0, 0.0085});
  body.advance(std::vector{inside}, std::vector{inside}, 0.02);
  EXPECT_FALSE(body.state().contacts[0].touching);
  move(body, inside, {0, 0, 0.008}, 5, 0.02);
  EXPECT_FALSE(body.state().contacts[0].touching);
}

TEST(Attachment, ALineThatDrawsTheEdgeOfAFlatSheetInItsPlaneLetsGoOfNoneOfIt) {
  // What it would have to push or pull across the sheet is round-off, of either sign.
  BodyDefinition sheet = make_body(make_sheet(40e-3, 20e-3, 200), 1e-3, neo_hookean(20e3));
  sheet.fluid.kind = FluidKind::kNone;
  sheet.fixed = {{.region = PlaneRegion{.axis = 1, .at = -10e-3}}};
  Body body(sheet, {line_tool(0.042)}, quasi_static());
  body.settle();
  ToolPose pose = pose_at({0, 10e-3, 0});
  pose.axis = Eigen::Vector3d::UnitX();
  std::size_t held = 0;
  move(body, pose, pose.tip + Eigen::Vector3d(0.4e-3, 0, 0), 40, 0.02, [&](const ToolPose&) {
    if (held == 0) held = body.state().attachments.size();
    EXPECT_EQ(body.state().attachments.size(), held);
  });
  EXPECT_GT(held, 5u);
}

TEST(Attachment, AToolSetElsewhereLetsGo) {
  Body body(tube(), {point_tool()}, quasi_static());
  body.settle();
  move(body, pose_at({0, 0, 0.014}), {0, 0, 0.009}, 10, 0.02);
  EXPECT_GT(body.state().contacts[0].force.norm(), 0);
  const ToolPose away = pose_at({0, 0.01, 0.02});
  body.advance(std::vector{away}, std::vector{away}, 0.02);
  EXPECT_EQ(body.state().contacts[0].force.norm(), 0);
}

TEST(ContactPressure, TimesTheAreaOfTheStretchedWallIsTheForceOfTheTool) {
  BodyDefinition swollen = tube();
  swollen.fluid.initial_pressure = 1500;
  for (const ToolDefinition& tool : {point_tool(), sphere_tool(0.004)}) {
    Body body(swollen, {tool}, quasi_static());
    body.settle();
    move(body, pose_at({0, 0, 0.020}), {0, 0, 0.012}, 16, 0.02);
    const Eigen::VectorXd pressure = body.contact_pressure();
    const auto corner = [&](int vertex) { return body.state().equilibrium.position.segment<3>(3 * vertex); };
    double force = 0, rest_force = 0;
    for (int t = 0; t < body.model().triangles(); ++t) {
      const Eigen::Vector3i& triangle = body.model().surface[t];
      const Eigen::Vector3d first = corner(triangle[1]) - corner(triangle[0]);
      const Eigen::Vector3d second = corner(triangle[2]) - corner(triangle[0]);
      for (const int vertex : triangle) force += pressure[vertex] * first.cross(second).norm() / 6;
      for (const int vertex : triangle) rest_force += pressure[vertex] * body.model().rest[t].area / 3;
    }
    // Magnitudes are summed; the directions of a ball's contacts differ a little.
    EXPECT_NEAR(force, body.state().contacts[0].force.norm(), 0.1 * force) << tool.name;
    EXPECT_GT(force, 1.2 * rest_force) << tool.name << " presses a wall that is hardly stretched";
  }
}

}  // namespace
}  // namespace thinwall
