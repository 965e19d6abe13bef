// A tool that comes upon what `fixed` holds: two things that cannot give way have no force between them that means
// anything.

#include <gtest/gtest.h>

#include <string>

#include "engine/mesh/Shapes.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

/// A ball of 5 mm in the way down to 2 mm below a stretched sheet of 60 mm that is held at its border, `aside` metres
/// from the middle.
void press(double aside, const BodyDefinition& sheet) {
  Body body(sheet, {sphere_tool(5e-3)}, quasi_static());
  body.settle();
  move(body, pose_at({aside, 0, 1e-3}), {aside, 0, -2e-3}, 8, 0.02);
  EXPECT_LT(body.state().contacts[0].force.norm(), 1);
}

BodyDefinition held_sheet() {
  BodyDefinition sheet = make_body(make_sheet(60e-3, 60e-3, 800), 1e-3, neo_hookean(100e3));
  sheet.fluid.kind = FluidKind::kNone;
  sheet.prestretch = {{.first = 1.2, .second = 1.2}};
  sheet.fixed = {{.region = BoundaryRegion{}}};
  return sheet;
}

TEST(HeldContact, ABallThatMeetsTheHeldBorderEndsTheRun) {
  for (const double aside : {27e-3, 29e-3}) {
    try {
      press(aside, held_sheet());
      ADD_FAILURE() << "at " << aside << " m";
    } catch (const SimulationFailure& failure) {
      EXPECT_NE(std::string(failure.what()).find("`fixed` holds"), std::string::npos) << failure.what();
    }
  }
}

TEST(HeldContact, AStepThatIsRefusedPartWayLeavesTheBodyAsItWas) {
  Body body(held_sheet(), {sphere_tool(5e-3)}, quasi_static());
  body.settle();
  const Eigen::VectorXd before = body.state().equilibrium.position;
  const std::vector<ToolPose> above = {pose_at({15e-3, 0, 2e-3})}, below = {pose_at({28e-3, 0, -2e-3})};
  EXPECT_THROW(body.advance(above, below, 0.02), SimulationFailure);
  EXPECT_EQ((body.state().equilibrium.position - before).lpNorm<Eigen::Infinity>(), 0);
}

TEST(HeldContact, ABodyThatIsHeldAllOverSaysSo) {
  BodyDefinition ball = make_body(make_sphere(20e-3, 320), 1e-3, neo_hookean(50e3));
  ball.fixed = {{.region = AboveRegion{.axis = 2, .at = -1}}};
  Body body(ball, {sphere_tool(5e-3)}, quasi_static());
  body.settle();
  try {
    move(body, pose_at({0, 0, 20.5e-3}), {0, 0, 20e-3}, 5, 0.02);
    ADD_FAILURE();
  } catch (const SimulationFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("`fixed` holds"), std::string::npos) << failure.what();
  }
}

TEST(HeldContact, FluidThatFindsNoRoomSaysSo) {
  BodyDefinition ball = make_body(make_sphere(20e-3, 320), 1e-3, neo_hookean(50e3));
  ball.fixed = {{.region = WholeRegion{}}};
  Body body(ball, {}, quasi_static());
  body.settle();
  for (const double factor : {1.01, 0.99}) {
    try {
      body.advance({}, {}, 0.02, filling(body, factor * body.model().rest_volume));
      ADD_FAILURE() << factor;
    } catch (const SimulationFailure& failure) {
      EXPECT_NE(std::string(failure.what()).find("or to fluid that is filled in or taken out"), std::string::npos)
          << failure.what();
    }
  }
}

TEST(HeldContact, ABallBesideTheHeldBorderPresses) {
  EXPECT_NO_THROW(press(24e-3, held_sheet()));
}

TEST(HeldContact, AWallThatIsHeldAcrossTheToolsWayOnlyGivesWay) {
  BodyDefinition sheet = held_sheet();
  sheet.fixed.push_back({.region = AboveRegion{.axis = 0, .at = -1}, .axes = {true, true, false}});
  EXPECT_NO_THROW(press(0, sheet));
}

}  // namespace
}  // namespace thinwall
