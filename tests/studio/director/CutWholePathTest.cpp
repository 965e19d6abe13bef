// Incisions whose path begins or ends between two time steps.

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "studio/director/ScenarioRun.hpp"

namespace thinwall {
namespace {

/// Metres that a fast blade cuts of a path of 20.85 mm in a sheet with edges of 1.2 mm. `standoff`: metres above the
/// path's beginning. `hold`: seconds at its end.
double length_of_cut(double standoff, double hold) {
  BodyScenario sheet{.name = "skin",
                     .surface = ShapeSource{.shape = Shape::kSheet, .length = 0.04, .width = 0.04, .triangles = 2400},
                     .thickness = {.standard = 1e-3},
                     .material = {.law = find_wall_law("neo_hookean"), .parameters = {100e3}}};
  sheet.toughness = Field<double>{.standard = 10};
  sheet.fluid.kind = FluidKind::kNone;
  sheet.fixed = {{.region = BoundaryRegion{}}};
  Scenario scenario{.name = "test", .title = "test"};
  scenario.bodies = {sheet};
  scenario.tools = {{.name = "blade", .kind = ToolKind::kScalpel, .length = 0.01, .width = 1e-3, .thickness = 2e-4}};
  scenario.timeline = {{.action = InciseClip{.tool = "blade",
                                             .body = "skin",
                                             .path = {{-0.01, 3e-4, 0}, {0.01085, 3e-4, 0}},
                                             .direction = -Eigen::Vector3d::UnitZ(),
                                             .depth = 1e-4,
                                             .speed = 0.15,
                                             .hold = hold,
                                             .standoff = standoff}}};
  scenario.simulation = {.analysis = Analysis::kQuasiStatic, .time_step = 0.01};
  ScenarioRun run(scenario);
  while (run.step()) continue;
  return run.record().bodies.at(0).cut_length;
}

TEST(CutWholePath, IsMadeToItsEndAlsoWhereTheBladeGoesOutOfTheWallInTheSameStep) {
  // At the path after 10 ms, at its end after 149 ms, and without rest 0.15 mm on its way out after 150 ms.
  const double with_rest_at_end = length_of_cut(1.4e-3, 0.02);
  EXPECT_NEAR(with_rest_at_end, 0.02085, 2e-6);  // 2e-7 seen
  EXPECT_EQ(length_of_cut(1.4e-3, 0), with_rest_at_end);
}

TEST(CutWholePath, IsMadeFromItsBeginningAlsoWhereTheBladeHasGoneOnFromThereInTheSameStep) {
  // At the path after 4 ms, and 0.9 mm along it after 10 ms, at the end of its first step in the wall.
  EXPECT_NEAR(length_of_cut(5e-4, 0.02), 0.02085, 2e-6);  // 2e-7 seen
}

}  // namespace
}  // namespace thinwall
