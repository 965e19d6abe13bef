// Tools that `move`, the verb that the others are made of.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "studio/director/DirectedTool.hpp"
#include "studio/director/ScenarioRun.hpp"
#include "studio/scenario/InputError.hpp"
#include "tests/studio/director/HeldBall.hpp"

namespace thinwall {
namespace {

TEST(Move, AMoveThroughTheWallTouchesItAndCountsItsDepth) {
  Scenario scenario = ball_scenario();
  scenario.timeline = {{.action = MoveClip{.tool = "probe",
                                           .from = Eigen::Vector3d(0.001, 0, 0.03),
                                           .to = {0.001, 0, 0.018},
                                           .duration = 0.5,
                                           .ease = Ease::kLinear}}};
  ScenarioRun run(scenario);
  while (run.step()) {
  }
  const ToolRecord& tool = run.record().tools.at(0);
  EXPECT_EQ(tool.phase, "contact");
  EXPECT_GT(tool.depth, 0.0015);
  EXPECT_LT(tool.depth, 0.0035);
  EXPECT_GT(tool.force.z(), 0);
}

TEST(Move, AToolThatMeetsTwoBodiesOnItsWayCountsItsDepthFromTheNearer) {
  std::vector<std::unique_ptr<Body>> bodies;
  for (const double radius : {0.02, 0.01}) {
    BodyDefinition ball;
    ball.name = "ball";
    ball.mesh = make_sphere(radius, 320);
    ball.thickness.assign(ball.mesh.triangles.size(), 1e-3);
    ball.materials = {{find_wall_law("neo_hookean"), {20e3}}};
    bodies.push_back(std::make_unique<Body>(ball, std::vector<ToolDefinition>{}, SimulationOptions{}));
  }
  DirectedTool probe;
  probe.pose.tip = {0.001, 0.002, 0.03};
  probe.find_first_contact({.name = "probe", .kind = ToolKind::kPoint}, bodies, {.tip = {0.001, 0.002, 0}});
  ASSERT_TRUE(probe.first_contact);
  EXPECT_NEAR(probe.first_contact->z(), 0.02, 5e-4) << "where the larger ball is";
}

TEST(Move, AMoveOfAToolThatPressesCountsItsDepthFromTheContactThatItHas) {
  Scenario scenario = ball_scenario();
  Clip pressed = palpation(0.001);
  std::get<PalpateClip>(pressed.action).withdraw = false;
  MoveClip deeper{.tool = "probe", .to = {}, .direction = Eigen::Vector3d(0, 0, -1), .duration = 0.2};
  scenario.timeline = {pressed};
  ScenarioRun palpated(scenario);
  while (palpated.step()) {
  }
  const Eigen::Vector3d tip = palpated.record().tools.at(0).position;
  deeper.to = tip - Eigen::Vector3d(0, 0, 0.001);
  MoveClip back = deeper;
  back.to = tip + Eigen::Vector3d(0, 0, 0.001);
  scenario.timeline = {pressed, {.action = deeper}, {.action = back}};
  ScenarioRun run(scenario);
  double largest = 0;
  while (run.step()) largest = std::max(largest, run.record().tools.at(0).depth);
  // The turn lies between two steps, of 0.05 mm at most there.
  EXPECT_NEAR(largest, 0.004, 5e-5);
  EXPECT_NEAR(run.record().tools.at(0).depth, 0.002, 1e-9);
}

/// A rod pressed 3 mm into the ball, then the move.
Scenario pressed_and_moved(const MoveClip& move) {
  Scenario scenario = ball_scenario();
  scenario.tools = {{.name = "probe", .kind = ToolKind::kCapsule, .length = 0.02, .radius = 0.003}};
  Clip pressed = palpation(0.001);
  std::get<PalpateClip>(pressed.action).withdraw = false;
  scenario.timeline = {pressed, {.action = move}};
  return scenario;
}

TEST(Move, AToolThatPressesTurnsAlongItsMoveAndPassesNoWall) {
  ScenarioRun run(pressed_and_moved({.tool = "probe",
                                     .to = {0.001, 0, 0.0165},
                                     .direction = Eigen::Vector3d(0, 0, -1),
                                     .axis = Eigen::Vector3d(1, 0, 0),
                                     .duration = 0.4}));
  const double step = ball_scenario().simulation.time_step;
  Eigen::Vector3d axis(0, 1, 0);
  double widest = 0, highest = 0, given = 0;
  while (run.step()) {
    const auto& now = run.snapshot().tools.at(0).axis;
    const Eigen::Vector3d next(now[0], now[1], now[2]);
    widest = std::max(widest, std::acos(std::min(1.0, axis.dot(next))));
    axis = next;
    highest = std::max(highest, run.record().tools.at(0).force.norm());
    given = std::max(given, std::abs(run.record().bodies.at(0).numerical));
  }
  std::printf("turned by %.4f rad a step at most, pressed with %.4f N, integrator %.3g of %.3g J\n", widest, highest,
              given, run.record().bodies.at(0).tool_work);
  EXPECT_LT((axis - Eigen::Vector3d::UnitX()).norm(), 1e-7);
  EXPECT_LT(widest, 1.5 * (std::numbers::pi / 2) * step / 0.4 + 1e-6) << "3/2 of the mean speed with its ease";
  EXPECT_LT(given, 0.02 * run.record().bodies.at(0).tool_work);
}

TEST(Move, AToolThatLeavesTheWallKeepsItsAttitudeAndIsFree) {
  ScenarioRun run(pressed_and_moved({.tool = "probe", .to = {0.001, 0, 0.03}, .duration = 0.2}));
  double pulled = 0;
  while (run.step()) {
    EXPECT_EQ(run.snapshot().tools.at(0).direction, (std::array<double, 3>{0, 0, -1}));
    pulled = std::min(pulled, run.record().tools.at(0).force.z());
  }
  EXPECT_GE(pulled, 0) << "what presses from above never pulls";
  EXPECT_EQ(run.record().tools.at(0).force.norm(), 0);
}

TEST(Move, AToolAtItsStandOffMovesAwayAsThePalpationHasTurnedIt) {
  Scenario scenario = ball_scenario();
  Clip oblique = palpation(0.001);
  const Eigen::Vector3d direction = Eigen::Vector3d(0.3, 0.2, -1).normalized();
  std::get<PalpateClip>(oblique.action).direction = direction;
  scenario.timeline = {oblique, {.action = MoveClip{.tool = "probe", .to = {0, 0, 0.04}, .duration = 0.1}}};
  ScenarioRun run(scenario);
  while (run.step()) {
    const auto& now = run.snapshot().tools.at(0).direction;
    EXPECT_LT((Eigen::Vector3d(now[0], now[1], now[2]) - direction).norm(), 1e-15);
  }
}

TEST(Move, AnAxisAlongTheDirectionThatAMoveWouldKeepIsRefusedBeforeTheRun) {
  EXPECT_THROW(ScenarioRun(pressed_and_moved({.tool = "probe", .to = {0, 0, 0.03}, .axis = Eigen::Vector3d(0, 0, 1)})),
               InputErrors);
}

}  // namespace
}  // namespace thinwall
