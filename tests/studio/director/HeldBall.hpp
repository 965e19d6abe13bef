#pragma once

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// A quasi-static scenario with a neo-Hookean `ball` of 20 mm radius at 200 Pa, held below, without tools and clips.
/// `time_step`: seconds.
inline Scenario held_ball(int triangles, double time_step) {
  BodyScenario ball{.name = "ball",
                    .surface = ShapeSource{.shape = Shape::kSphere, .radius = 0.02, .triangles = triangles},
                    .thickness = {.standard = 1e-3},
                    .material = {.law = find_wall_law("neo_hookean"), .parameters = {20e3}}};
  ball.fluid.initial_pressure = 200;
  ball.fixed = {{.region = BelowRegion{.axis = 2, .at = -0.01}}};
  Scenario scenario{.name = "test", .title = "test"};
  scenario.bodies = {ball};
  scenario.simulation = {.analysis = Analysis::kQuasiStatic, .time_step = time_step};
  return scenario;
}

/// The same with a point, `probe`; each test adds its clips.
inline Scenario ball_scenario() {
  Scenario scenario = held_ball(320, 0.02);
  scenario.tools = {{.name = "probe", .kind = ToolKind::kPoint}};
  return scenario;
}

/// Of its crown, `x` beside the middle, by `depth`; metres.
inline Clip palpation(double x, double depth = 0.003) {
  return {.action = PalpateClip{.tool = "probe",
                                .body = "ball",
                                .at = {x, 0, 0.02},
                                .depth = depth,
                                .speed = 0.02,
                                .hold = 0.1,
                                .standoff = 0.004}};
}

/// A held ball with a needle that goes into the crown. `toughness`: joule / metre^2. `depth`: metres.
inline Scenario pierced_ball(int triangles, double toughness, double depth) {
  Scenario scenario = held_ball(triangles, 0.02);
  scenario.bodies[0].toughness = Field<double>{.standard = toughness};
  scenario.tools = {{.name = "needle", .kind = ToolKind::kNeedle, .length = 0.06, .radius = 0.0005}};
  PierceClip clip;
  clip.tool = "needle";
  clip.body = "ball";
  clip.at = {0.001, 0.0003, 0.02};
  clip.depth = depth;
  clip.speed = 0.05;
  clip.standoff = 0.002;
  scenario.timeline = {{.action = clip}};
  return scenario;
}

}  // namespace thinwall
