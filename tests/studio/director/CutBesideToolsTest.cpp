// Incisions beside what another tool holds.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "studio/director/ScenarioRun.hpp"

namespace thinwall {
namespace {

/// A coarse sheet whose middle closed jaws hold, and a cut half around them.
Scenario excision_in_jaws() {
  BodyScenario sheet{.name = "skin",
                     .surface = ShapeSource{.shape = Shape::kSheet, .length = 0.04, .width = 0.04, .triangles = 300},
                     .thickness = {.standard = 1e-3},
                     .material = {.law = find_wall_law("neo_hookean"), .parameters = {40e3}}};
  sheet.model = WallModel::kShell;
  sheet.toughness = Field<double>{.standard = 100};
  sheet.prestretch = {.standard = {.first = 1.05, .second = 1.05}};
  sheet.fluid.kind = FluidKind::kNone;
  sheet.fixed = {{.region = BoundaryRegion{}}};
  Scenario scenario{.name = "test", .title = "test"};
  scenario.bodies = {sheet};
  scenario.tools = {
      {.name = "jaws", .kind = ToolKind::kForceps, .length = 0.03, .width = 4e-3, .thickness = 1.5e-3, .friction = 0.8},
      {.name = "blade", .kind = ToolKind::kScalpel, .length = 0.012, .width = 0.003, .thickness = 4e-4}};
  scenario.tools[0].opening = 4e-3;
  scenario.simulation = {.analysis = Analysis::kDynamic, .time_step = 0.01};
  scenario.timeline = {
      {.action = GraspClip{.tool = "jaws", .body = "skin", .depth = 2e-3, .speed = 0.04, .duration = 0.2}},
      {.action = InciseClip{.tool = "blade",
                            .body = "skin",
                            .path = {{6e-3, 0, 0}, {0, 6e-3, 0}, {-6e-3, 0, 0}},
                            .direction = -Eigen::Vector3d::UnitZ(),
                            .depth = 0.003,
                            .speed = 0.06}}};
  return scenario;
}

TEST(Incision, BesideJawsThatHoldTheWallLaysNoNewTrianglesIntoThem) {
  ScenarioRun run(excision_in_jaws());
  double most_contact = 0;
  while (run.step()) most_contact = std::max(most_contact, run.record().bodies.at(0).contact);
  const BodyRecord& body = run.record().bodies.at(0);
  EXPECT_GT(body.cut_length, 0.012);
  EXPECT_LT(most_contact, 0.01 * body.fracture);
  EXPECT_LT(std::abs(body.numerical), 0.1 * body.fracture);
}

/// A taut sheet of triangles of 5 mm that a finger presses 4 mm deep, draws 3 mm aside and holds so, while a blade cuts
/// it 30 mm from there.
Scenario cut_far_from(const ToolDefinition& finger) {
  BodyScenario sheet{.name = "skin",
                     .surface = ShapeSource{.shape = Shape::kSheet, .length = 0.06, .width = 0.06, .triangles = 400},
                     .thickness = {.standard = 1e-3},
                     .material = {.law = find_wall_law("neo_hookean"), .parameters = {40e3}}};
  sheet.toughness = Field<double>{.standard = 150};
  sheet.prestretch = {.standard = {.first = 1.1, .second = 1.1}};
  sheet.fluid.kind = FluidKind::kNone;
  sheet.fixed = {{.region = BoundaryRegion{}}};
  Scenario scenario{.name = "test", .title = "test"};
  scenario.bodies = {sheet};
  scenario.tools = {finger,
                    {.name = "blade", .kind = ToolKind::kScalpel, .length = 0.012, .width = 0.003, .thickness = 4e-4}};
  scenario.simulation = {.analysis = Analysis::kQuasiStatic, .time_step = 0.01};
  const PalpateClip press{
      .tool = finger.name, .body = "skin", .at = {-0.015, -0.014, 0}, .depth = 4e-3, .speed = 0.1, .withdraw = false};
  const InciseClip incision{.tool = "blade",
                            .body = "skin",
                            .path = {{0.004, 0.012, 0}, {0.016, 0.013, 0}},
                            .direction = -Eigen::Vector3d::UnitZ(),
                            .depth = 0.004,
                            .speed = 0.04};
  scenario.timeline = {{.action = press},
                       {.action = MoveClip{.tool = finger.name, .by = Eigen::Vector3d(3e-3, 1e-3, 0), .duration = 0.1}},
                       {.action = incision}};
  return scenario;
}

TEST(Incision, LeavesAFingerFarFromItTheForceThatItHas) {
  // A point is prescribed, a ball smaller than the triangles presses on edges and faces, and a rough one holds by
  // friction too. A cut held the wall by what each of these did to it, so that the finger felt a tenth of its force.
  const ToolDefinition point{.name = "finger", .kind = ToolKind::kPoint};
  ToolDefinition ball{.name = "finger", .kind = ToolKind::kSphere};
  ball.radius = 2e-3;
  ToolDefinition rough = ball;
  rough.friction = 0.6;
  for (const ToolDefinition& finger : {point, ball, rough}) {
    ScenarioRun run(cut_far_from(finger));
    std::optional<Eigen::Vector3d> held;  // newton, when the blade sets out
    double most_change = 0;               // newton
    while (run.step()) {
      const ToolRecord& felt = run.record().tools.at(0);
      if (!held && run.record().tools.at(1).phase == "contact") held = felt.force;
      if (held) most_change = std::max(most_change, (felt.force - *held).norm());
    }
    ASSERT_TRUE(held);
    EXPECT_GT(run.record().bodies.at(0).cut_length, 0.01);
    // What the dent below the blade slackens the sheet.
    EXPECT_LT(most_change, 0.15 * held->norm()) << finger.radius << " m, friction " << finger.friction;
  }
}

}  // namespace
}  // namespace thinwall
