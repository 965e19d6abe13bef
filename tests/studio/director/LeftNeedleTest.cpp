// Needles that a clip leaves in a wall.

#include <gtest/gtest.h>

#include <cmath>

#include "studio/director/ScenarioRun.hpp"

namespace thinwall {
namespace {

PierceClip piercing(double x) {
  PierceClip clip;
  clip.tool = "needle";
  clip.body = "ball";
  clip.at = {x, 0, 0.02};
  clip.depth = 0.01;
  clip.speed = 0.08;
  return clip;
}

/// A filled ball, held below, that a needle pierces twice, without being drawn out in between.
Scenario two_piercings() {
  BodyScenario ball{.name = "ball",
                    .surface = ShapeSource{.shape = Shape::kSphere, .radius = 0.02, .triangles = 320},
                    .thickness = {.standard = 1e-3},
                    .material = {.law = find_wall_law("neo_hookean"), .parameters = {40e3}}};
  ball.toughness = Field<double>{.standard = 100};
  ball.fluid.initial_pressure = 700;
  ball.fixed = {{.region = BelowRegion{.axis = 2, .at = -0.01}}};
  Scenario scenario{.name = "test", .title = "test"};
  scenario.bodies = {ball};
  ToolDefinition needle{.name = "needle", .kind = ToolKind::kNeedle};
  needle.radius = 8e-4;
  needle.length = 0.08;
  needle.friction = 0.25;
  scenario.tools = {needle};
  scenario.simulation = {.analysis = Analysis::kDynamic, .time_step = 0.01};
  PierceClip first = piercing(0);
  first.withdraw = false;
  scenario.timeline = {{.action = first}, {.action = piercing(0.006)}};
  return scenario;
}

TEST(LeftNeedle, IsInItsPunctureNoMoreWhenTheNextClipSetsItElsewhere) {
  ScenarioRun run(two_piercings());
  double leaked = 0;
  while (run.step()) leaked = std::max(leaked, run.record().bodies.at(0).leaked);
  EXPECT_GT(run.record().bodies.at(0).cut_length, 3.8 * 8e-4);  // two slits as wide as it is
  EXPECT_GT(leaked, 0);
}

}  // namespace
}  // namespace thinwall
