// Incisions beside what another tool holds.

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace thinwall
