// A ring that nothing holds along the axis of two plates but the plates.

#include <gtest/gtest.h>

#include "studio/director/ScenarioRun.hpp"

namespace thinwall {
namespace {

Scenario ring_between_plates() {
  BodyScenario ring{
      .name = "ring",
      .surface = ShapeSource{.shape = Shape::kCylinder, .radius = 0.025, .length = 0.01, .triangles = 2560},
      .model = WallModel::kShell,
      .thickness = {.standard = 0.5e-3},
      .material = {.law = find_wall_law("st_venant_kirchhoff"), .parameters = {1e6, 0}}};
  ring.fluid.kind = FluidKind::kNone;
  ring.fixed = {{.region = PlaneRegion{.axis = 0, .at = 0, .within = 1e-5}, .axes = {true, false, false}},
                {.region = PlaneRegion{.axis = 1, .at = 0, .within = 3e-3}, .axes = {false, true, false}}};
  Scenario scenario{.name = "test", .title = "test"};
  scenario.bodies = {ring};
  for (const double side : {-1., 1.}) {
    const std::string name = side < 0 ? "bottom" : "top";
    scenario.tools.push_back(
        {.name = name, .kind = ToolKind::kPlate, .length = 0.04, .width = 0.06, .thickness = 2e-3});
    scenario.timeline.push_back({.action = PalpateClip{.tool = name,
                                                       .body = "ring",
                                                       .at = {0, 0, 0.025 * side},
                                                       .direction = {0, 0, -side},
                                                       .axis = Eigen::Vector3d::UnitY(),
                                                       .depth = 0.8e-3,
                                                       .speed = 0.01,
                                                       .standoff = 5e-5,
                                                       .withdraw = false},
                                 .start = 0});
  }
  scenario.simulation = {.analysis = Analysis::kQuasiStatic, .time_step = 0.02};
  return scenario;
}

TEST(RingBetweenPlates, FindsTheContactsOfEachStepInFewIterations) {
  ScenarioRun run(ring_between_plates());
  int most = 0;
  while (run.step()) most = std::max(most, run.record().bodies.at(0).newton_iterations);
  // 8 seen; 17 where contacts border the factor of the ring without them, which hardly resists its fall.
  EXPECT_LE(most, 12);
}

}  // namespace
}  // namespace thinwall
