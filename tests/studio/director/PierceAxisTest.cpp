// The turn of a needle about its shaft, along which its slit lies.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "studio/director/ScenarioRun.hpp"

namespace thinwall {
namespace {

/// Joule that a needle with friction does as it goes through the middle of a sheet twice as long as wide and is drawn
/// out. `angle`: by which the sheet is turned about z, radians.
double work_of_piercing(double angle, const std::optional<Eigen::Vector3d>& axis) {
  const Eigen::AngleAxisd turned(angle, Eigen::Vector3d::UnitZ());
  BodyScenario sheet{.name = "sheet",
                     .surface = ShapeSource{.shape = Shape::kSheet,
                                            .length = 0.04,
                                            .width = 0.02,
                                            .triangles = 600,
                                            .placed = SurfacePlacement{.turned = turned}},
                     .thickness = {.standard = 1e-3},
                     .material = {.law = find_wall_law("neo_hookean"), .parameters = {100e3}}};
  sheet.toughness = Field<double>{.standard = 50};
  sheet.fluid.kind = FluidKind::kNone;
  sheet.fixed = {{.region = BoundaryRegion{}}};
  Scenario scenario{.name = "test", .title = "test"};
  scenario.bodies = {sheet};
  ToolDefinition needle{.name = "needle", .kind = ToolKind::kNeedle};
  needle.radius = 8e-4;
  needle.length = 0.04;
  needle.friction = 0.3;
  scenario.tools = {needle};
  PierceClip pierce;
  pierce.tool = "needle";
  pierce.body = "sheet";
  pierce.axis = axis;
  pierce.depth = 0.01;
  pierce.speed = 0.05;
  scenario.timeline = {{.action = pierce}};
  scenario.simulation = {.analysis = Analysis::kQuasiStatic, .time_step = 0.01};
  ScenarioRun run(scenario);
  while (run.step()) continue;
  return run.record().bodies.at(0).tool_work;
}

TEST(PierceAxis, TurnsTheSlitSoThatAScenarioThatIsTurnedAsAWholeTakesTheSameWork) {
  const double work = work_of_piercing(0, std::nullopt), angle = 0.6;
  EXPECT_NEAR(work_of_piercing(angle, Eigen::Vector3d(-std::sin(angle), std::cos(angle), 0)), work,
              1e-9 * work);                                                        // 1e-13 seen
  EXPECT_GT(std::abs(work_of_piercing(angle, std::nullopt) - work), 1e-2 * work);  // 4 % seen
}

}  // namespace
}  // namespace thinwall
