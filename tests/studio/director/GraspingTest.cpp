#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "studio/director/ScenarioRun.hpp"
#include "tests/studio/director/HeldBall.hpp"

namespace thinwall {
namespace {

/// Forceps that pinch the crown of a filled hemisphere, lift it, and let it go.
Scenario grasping_scenario() {
  BodyScenario organ{.name = "organ",
                     .surface = ShapeSource{.shape = Shape::kHemisphere, .radius = 0.02, .triangles = 1024},
                     .thickness = {.standard = 1e-3},
                     .material = {.law = find_wall_law("neo_hookean"), .parameters = {20e3}}};
  organ.fluid.initial_pressure = 300;
  organ.fixed = {{.region = GroupRegion{"base"}}};
  Scenario scenario{.name = "test", .title = "test"};
  scenario.bodies = {organ};
  scenario.tools = {{.name = "grip",
                     .kind = ToolKind::kForceps,
                     .length = 0.03,
                     .width = 0.006,
                     .thickness = 0.002,
                     .opening = 0.01,
                     .friction = 0.8}};
  scenario.simulation = {.analysis = Analysis::kDynamic, .time_step = 0.02};
  scenario.record.points = {{.name = "crown", .body = "organ", .at = {0, 0, 0.02}}};
  scenario.timeline = {{.action = GraspClip{.tool = "grip",
                                            .body = "organ",
                                            .at = {0, 0, 0.03},
                                            .depth = 0.006,
                                            .speed = 0.02,
                                            .standoff = 0.001,
                                            .to = 0.002,
                                            .duration = 0.6}},
                       {.action = MoveClip{.tool = "grip", .to = {0, 0, 0.02}, .duration = 0.4}},
                       {.action = WaitClip{.duration = 0.1}},
                       {.action = ReleaseClip{.tool = "grip", .duration = 0.5}},
                       {.action = WaitClip{.duration = 0.2}}};
  return scenario;
}

/// What a run tells of its clip `number`, from 1.
std::string told_of(const ScenarioRun& run, int number) {
  std::string all;
  for (const std::string& one : run.warnings()) {
    if (one.starts_with("timeline[" + std::to_string(number) + "]: ")) all += one + "\n";
  }
  return all;
}

/// The same at the end of a run.
std::string told_of(const Scenario& scenario, int number) {
  ScenarioRun run(scenario);
  while (run.step()) {
  }
  return told_of(run, number);
}

TEST(Grasping, JawsLiftTheWallTheyHoldUntilTheyLetGo) {
  ScenarioRun run(grasping_scenario());
  const double rest = run.record().points.at(0).position.z();
  double highest = 0, pull = 0;
  std::map<std::string, int> steps_in_phase;
  while (run.step()) {
    highest = std::max(highest, run.record().points.at(0).position.z());
    pull = std::min(pull, run.record().tools.at(0).force.z());
    ++steps_in_phase[run.record().tools.at(0).phase];
    const BodyRecord& body = run.record().bodies.at(0);
    EXPECT_NEAR(body.elastic + body.kinetic + body.contact + body.friction + body.viscous + body.numerical,
                body.tool_work + body.script_work, 1e-9 * body.elastic);
  }
  std::printf("lifted by %.2f mm, pulled with %.3f N\n", 1e3 * (highest - rest), pull);
  EXPECT_GT(highest, rest + 2e-3);
  EXPECT_LT(pull, -0.03) << "the tissue holds the tool back";
  for (const char* phase : {"hold", "withdrawal"}) EXPECT_GT(steps_in_phase[phase], 5) << phase;
  EXPECT_NEAR(run.record().points.at(0).position.z(), rest, 0.2e-3);
  EXPECT_EQ(run.record().tools.at(0).force.norm(), 0);
  EXPECT_EQ(run.snapshot().tools.at(0).opening, 0.01);
  EXPECT_EQ(told_of(run, 1), "") << "the jaws have let go by themselves";
}

TEST(Grasping, TheDepthOfALiftIsTheTravelSinceFirstContact) {
  Scenario scenario = grasping_scenario();
  scenario.timeline.resize(2);
  ScenarioRun run(scenario);
  double touched = 0, squeezed = 0;  // metres: height of the tips at first contact, depth with closed jaws
  while (run.step()) {
    const ToolRecord& tool = run.record().tools.at(0);
    if (tool.phase == "hold") {
      squeezed = tool.depth;
      touched = tool.position.z() + tool.depth;
    } else if (squeezed > 0) {
      EXPECT_NEAR(tool.depth, std::max(0.0, touched - tool.position.z()), 1e-12) << run.time();
    }
  }
  EXPECT_GT(squeezed, 2e-3);
}

TEST(Grasping, JawsStopWhereTheyHoldFirmlyEnough) {
  Scenario scenario = grasping_scenario();
  std::get<GraspClip>(scenario.timeline[0].action).grip = 0.05;
  scenario.timeline.resize(1);
  ScenarioRun run(scenario);
  while (run.step()) {
  }
  std::printf("stopped at %.3f mm\n", 1e3 * run.snapshot().tools.at(0).opening);
  EXPECT_GT(run.snapshot().tools.at(0).opening, 0.0025);
  EXPECT_LT(run.snapshot().tools.at(0).opening, 0.009);
  EXPECT_EQ(told_of(run, 1), "");
}

TEST(Grasping, JawsStopAtTheirGripHoweverLongTheSteps) {
  // A step of 20 ms closes them by 0.27 mm, from where they touch nothing to far beyond their grip.
  std::vector<double> openings;  // metres
  for (const double step : {0.02, 0.005}) {
    Scenario scenario = grasping_scenario();
    std::get<ShapeSource>(scenario.bodies[0].surface).triangles = 256;
    scenario.simulation = {.analysis = Analysis::kQuasiStatic, .time_step = step};
    std::get<GraspClip>(scenario.timeline[0].action).grip = 0.05;
    scenario.timeline.resize(1);
    ScenarioRun run(scenario);
    while (run.step()) {
    }
    openings.push_back(run.snapshot().tools.at(0).opening);
  }
  EXPECT_NEAR(openings[0], openings[1], 0.02e-3) << "1 % of the grip is 0.01 mm of opening";
}

TEST(Grasping, SmallJawsGraspATenseCoarseBalloonAndMoveIt) {
  // Edges of the wall lie along rims of the jaws, and are longer than these.
  Scenario scenario = held_ball(200, 0.01);
  BodyScenario& ball = scenario.bodies[0];
  ball.thickness = {.standard = 0.8e-3};
  ball.material = {.law = find_wall_law("mooney_rivlin"), .parameters = {20e3, 4e3}};
  ball.prestretch = {.standard = {.first = 1.3, .second = 1.3}};
  ball.fluid.initial_pressure = 300;
  ball.fixed = {{.region = BelowRegion{.axis = 2, .at = -0.015}}};
  scenario.simulation.analysis = Analysis::kDynamic;
  scenario.tools = {{.name = "grip",
                     .kind = ToolKind::kForceps,
                     .length = 0.015,
                     .width = 0.004,
                     .thickness = 0.002,
                     .opening = 0.008}};
  scenario.timeline = {{.action = GraspClip{.tool = "grip",
                                            .body = "ball",
                                            .at = {0, 0, 0.02},
                                            .depth = 0.003,
                                            .speed = 0.02,
                                            .standoff = 0.002,
                                            .to = 0.003,
                                            .duration = 0.5}},
                       {.action = MoveClip{.tool = "grip", .to = {0, 0.008, 0.023}, .duration = 0.5}}};
  ScenarioRun run(scenario);
  while (run.step()) {
  }
  EXPECT_NEAR(run.snapshot().tools.at(0).opening, 0.003, 1e-9);
  EXPECT_GT(run.record().bodies.at(0).volume, 0);
}

TEST(Grasping, TellsThatJawsHaveClosedOnNothing) {
  Scenario scenario = grasping_scenario();
  scenario.timeline.resize(1);
  std::get<GraspClip>(scenario.timeline[0].action).depth = -0.004;
  EXPECT_EQ(told_of(scenario, 1),
            "timeline[1]: forceps `grip` have closed to 2 mm and squeezed nothing; for a wall between the jaws go "
            "deeper, turn `axis`, or close further\n");
}

TEST(Grasping, TellsThatJawsHaveNotReachedTheirGrip) {
  Scenario scenario = grasping_scenario();
  scenario.timeline.resize(1);
  std::get<GraspClip>(scenario.timeline[0].action).grip = 500;
  EXPECT_NE(told_of(scenario, 1).find("N at most, less than `grip` = 500 N"), std::string::npos);
}

TEST(Grasping, TellsSinceWhenTheWallHasSlippedOutOfTheJaws) {
  Scenario scenario = grasping_scenario();
  scenario.tools[0].friction = 0;
  scenario.timeline.resize(2);
  std::get<MoveClip>(scenario.timeline[1].action).to = {0, 0, 0.06};
  const std::string told = told_of(scenario, 1);
  EXPECT_NE(told.find("forceps `grip` have held nothing any more since "), std::string::npos) << told;
  EXPECT_EQ(told.find("edges of the triangles"), std::string::npos) << told;
}

TEST(Grasping, TellsThatTrianglesAreLongerThanJawsThatHaveClosedOnNothingAreWide) {
  Scenario scenario = grasping_scenario();
  scenario.tools[0].width = 0.002;
  scenario.timeline.resize(1);
  std::get<GraspClip>(scenario.timeline[0].action).depth = -0.004;
  const std::string told = told_of(scenario, 1);
  EXPECT_NE(told.find("squeezed nothing; "), std::string::npos) << told;
  EXPECT_NE(told.find("; edges of the triangles of body `organ`, 2.44"), std::string::npos) << told;
  EXPECT_NE(told.find(" mm, are longer than the jaws are wide, 2 mm: "), std::string::npos) << told;
}

}  // namespace
}  // namespace thinwall
