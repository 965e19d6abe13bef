#include "studio/director/ScenarioRun.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "engine/simulation/SimulationFailure.hpp"
#include "renderer/snapshot/SurfaceFields.hpp"
#include "studio/organs/BodyBuilder.hpp"
#include "studio/scenario/InputError.hpp"
#include "tests/studio/director/HeldBall.hpp"

namespace thinwall {
namespace {

TEST(ScenarioRun, TheFirstRecordIsTheEquilibriumAtTimeZero) {
  Scenario scenario = ball_scenario();
  scenario.timeline = {palpation(0.001)};
  const ScenarioRun run(scenario);
  EXPECT_EQ(run.time(), 0);
  EXPECT_EQ(run.record().bodies.at(0).pressure, 200);
  EXPECT_GT(run.record().bodies.at(0).volume, 0);
  EXPECT_EQ(run.record().bodies.at(0).volume, run.record().bodies.at(0).fluid_volume);
  EXPECT_EQ(run.record().tools.at(0).phase, "approach") << "its clip begins then";
  EXPECT_EQ(run.snapshot().surfaces.at(0).positions.size(), run.snapshot().surfaces[0].topology->rest_positions.size());
}

TEST(ScenarioRun, AtTimeZeroTheToolWhoseClipBeginsThenIsNotIdle) {
  Scenario scenario = ball_scenario();
  const ToolDefinition first = scenario.tools[0];
  scenario.tools.push_back(first);
  scenario.tools[0].name = "spare";
  scenario.timeline = {palpation(0.001)};
  EXPECT_EQ(ScenarioRun(scenario).record().tools.at(0).phase, "idle");
  EXPECT_EQ(ScenarioRun(scenario).record().tools.at(1).phase, "approach");
  scenario.timeline = {Clip{.action = WaitClip{.duration = 0.1}}, palpation(0.001)};
  EXPECT_EQ(ScenarioRun(scenario).record().tools.at(1).phase, "idle");
}

TEST(ScenarioRun, BodiesThatMayPassThroughEachOtherAreToldOnce) {
  Scenario scenario = ball_scenario();
  BodyScenario other = scenario.bodies[0];
  other.name = "other";
  scenario.bodies.push_back(other);
  scenario.timeline = {palpation(0.001)};
  const auto told = [&] {
    ScenarioRun run(scenario);
    run.step();
    const std::vector<std::string> warnings = run.warnings();
    return std::ranges::count_if(warnings, [](const std::string& warning) {
      return warning.find("bodies `ball` and `other` come so near from") != std::string::npos;
    });
  };
  EXPECT_EQ(told(), 1);
  scenario.bodies[1].fixed = {{.region = WholeRegion{}}};
  EXPECT_EQ(told(), 0) << "it lies in scenery";
}

TEST(ScenarioRun, ABodyThatIsFixedAllOverIsSceneryForTheOthers) {
  Scenario scenario = ball_scenario();
  scenario.timeline = {palpation(0.001)};
  Scenario dressed = scenario;
  BodyScenario& scenery = dressed.bodies.emplace_back(scenario.bodies[0]);
  scenery.name = "scenery";
  std::get<ShapeSource>(scenery.surface).placed = SurfacePlacement{.at = {0.03, 0, 0}};
  scenery.fixed = {{.region = WholeRegion{}}};
  scenery.fluid.initial_pressure = 1000;
  std::vector<std::string> notes;
  std::vector<Float3> given;
  const BodyDefinition definition = build_body(scenery, notes);
  for (const Eigen::Vector3d& vertex : definition.mesh.vertices) {
    given.push_back({static_cast<float>(vertex.x()), static_cast<float>(vertex.y()), static_cast<float>(vertex.z())});
  }
  ScenarioRun alone(scenario), run(dressed);
  while (run.step()) {
    ASSERT_TRUE(alone.step());
    EXPECT_EQ(run.record().tools.at(0).force, alone.record().tools.at(0).force) << run.time();
  }
  EXPECT_EQ(run.snapshot().surfaces.at(1).positions, given);
  EXPECT_TRUE(run.snapshot().surfaces.at(1).topology->is_scenery);
  EXPECT_FALSE(run.snapshot().surfaces.at(0).topology->is_scenery);
  scenery.fixed = {{.region = AboveRegion{.at = -1}}};
  EXPECT_FALSE(ScenarioRun(dressed).snapshot().surfaces.at(1).topology->is_scenery) << "as clips and labels see it";
}

TEST(ScenarioRun, TheStressOfABallUnderPressureIsThatOfLaplace) {
  Scenario scenario = ball_scenario();
  scenario.bodies[0].surface = ShapeSource{.shape = Shape::kSphere, .radius = 0.02, .triangles = 5120};
  scenario.bodies[0].fixed.clear();
  scenario.bodies[0].fluid.initial_pressure = 500;
  const ScenarioRun run(scenario);
  const SnapshotSurface& surface = run.snapshot().surfaces.at(0);
  const std::vector<double> thickness = current_thickness(surface);
  const SnapshotField* largest = find_field(surface, kLargestStressField, FieldLocation::kTriangle);
  const SnapshotField* smallest = find_field(surface, kSmallestStressField, FieldLocation::kTriangle);
  ASSERT_TRUE(largest && smallest);
  const double radius = std::cbrt(3 * run.record().bodies.at(0).volume / (4 * M_PI));
  EXPECT_GT(radius, 0.0205);
  double mean = 0, largest_error = 0;
  for (std::size_t t = 0; t < thickness.size(); ++t) {
    EXPECT_NEAR(thickness[t], 1e-3 * 0.02 * 0.02 / (radius * radius), 2e-5);
    const double stress = 500 * radius / (2 * thickness[t]);
    for (const SnapshotField* field : {largest, smallest}) {
      mean += 0.5 * field->values[t] / stress / static_cast<double>(thickness.size());
      largest_error = std::max(largest_error, std::abs(field->values[t] / stress - 1));
    }
  }
  // Chords of 2 degrees; the triangles around the twelve vertices with five neighbours are the worst.
  EXPECT_NEAR(mean, 1, 2e-3);
  EXPECT_LT(largest_error, 0.05);
}

TEST(ScenarioRun, CutsArePlannedOnTheSurfaceAndTheirDurationIsKnown) {
  Scenario scenario = ball_scenario();
  scenario.tools = {{.name = "knife", .kind = ToolKind::kScalpel, .length = 0.02, .width = 0.004, .thickness = 3e-4}};
  InciseClip incise{.tool = "knife",
                    .body = "ball",
                    .path = {{0.005, 0, 0.02}, {-0.005, 0, 0.02}},
                    .path_locations = {{"a.yaml", 3, 7}, {"a.yaml", 3, 20}},
                    .depth = 0.002,
                    .speed = 0.01,
                    .hold = 0.1,
                    .standoff = 0.003};
  scenario.timeline = {{.action = incise}};
  const ScenarioRun run(scenario);
  // The points go to the nearest ones of the sphere, on which the way between them is an arc.
  const double arc = 0.02 * 2 * std::atan(0.25);
  EXPECT_NEAR(run.planned_duration(), (2 * 0.005 + arc) / 0.01 + 0.1, 0.02);
  EXPECT_GT(run.snapshot().tools.at(0).tip[2], 0.0215);
  std::get<InciseClip>(scenario.timeline[0].action).path[1] = {-0.005, 0, 0.04};
  try {
    const ScenarioRun refused(scenario);
    FAIL() << "no error";
  } catch (const InputErrors& errors) {
    EXPECT_EQ(to_text(errors.diagnostics().at(0).location), "a.yaml:3:20");
  }
}

TEST(ScenarioRun, AToolThatNoClipDrivesTouchesNothing) {
  // It would lie in the ball otherwise, at the origin.
  Scenario scenario = ball_scenario();
  scenario.tools.push_back({.name = "spare", .kind = ToolKind::kSphere, .radius = 0.003});
  scenario.timeline = {palpation(0.001)};
  ScenarioRun run(scenario);
  while (run.step()) EXPECT_EQ(run.record().tools.at(1).contact_area, 0);
  EXPECT_EQ(run.record().tools.at(1).force, Eigen::Vector3d(0, 0, 0));
}

TEST(ScenarioRun, ForceAndDepthBeginWithContactAndEndWithIt) {
  Scenario scenario = ball_scenario();
  scenario.timeline = {palpation(0.001)};
  ScenarioRun run(scenario);
  std::map<std::string, int> steps_in_phase;
  double largest_depth = 0;
  while (run.step()) {
    const ToolRecord& tool = run.record().tools.at(0);
    ++steps_in_phase[tool.phase];
    largest_depth = std::max(largest_depth, tool.depth);
    if (tool.phase == "approach") {
      EXPECT_EQ(tool.force.norm(), 0);
    }
    if (tool.phase == "hold") {
      EXPECT_GT(tool.force.z(), 0) << "the tissue pushes back";
    }
    if (tool.depth == 0) {
      EXPECT_EQ(tool.force.norm(), 0) << tool.phase;
    }
    EXPECT_EQ(run.snapshot().tools.at(0).depth, tool.depth);
  }
  EXPECT_NEAR(largest_depth, 0.003, 1e-12);
  for (const char* phase : {"approach", "contact", "hold", "withdrawal"}) EXPECT_GT(steps_in_phase[phase], 2) << phase;
  EXPECT_NEAR(run.time(), run.planned_duration(), scenario.simulation.time_step);
  // What the tool put in came back: a quasi-static elastic body keeps nothing, to the integrator's own account.
  const BodyRecord& body = run.record().bodies.at(0);
  EXPECT_NEAR(body.tool_work, body.numerical, 1e-10 * body.elastic);
}

TEST(ScenarioRun, ClipsFollowOneAnotherAndTheToolTouchesNothingInBetween) {
  Scenario scenario = ball_scenario();
  scenario.timeline = {palpation(-0.008), {.action = WaitClip{.duration = 0.1}}, palpation(0.008)};
  scenario.timeline[0].chapter = "left";
  scenario.timeline[2].chapter = "right";
  scenario.timeline[2].caption = "the other side";
  ScenarioRun run(scenario);
  ASSERT_EQ(run.captions().size(), 1u) << "what begins at time zero is told with the first moment";
  EXPECT_EQ(run.captions()[0].text, "Palpation: 3 mm deep at 20 mm/s");
  while (run.step()) {
    const ToolRecord& tool = run.record().tools.at(0);
    if (tool.depth == 0) {
      EXPECT_EQ(tool.force.norm(), 0) << "at " << run.time() << " s in " << tool.phase;
    }
  }
  ASSERT_EQ(run.chapters().size(), 2u);
  EXPECT_EQ(run.chapters()[1].text, "right");
  EXPECT_NEAR(run.chapters()[1].begin, run.chapters()[0].end + 0.1, 1e-12);
  ASSERT_EQ(run.captions().size(), 2u);
  EXPECT_EQ(run.captions()[0].text, "Palpation: 3 mm deep at 20 mm/s");
  EXPECT_EQ(run.captions()[1].text, "the other side");
}

TEST(ScenarioRun, WhatAClipDoesIsToldWhereNoOtherHasWords) {
  Scenario scenario = ball_scenario();
  scenario.timeline = {palpation(0), {.action = WaitClip{.duration = 0.05}, .start = 0.02}};
  EXPECT_EQ(ScenarioRun(scenario).captions().size(), 1u);
  scenario.timeline[1].caption = "Look at the dent";
  ScenarioRun run(scenario);
  EXPECT_TRUE(run.captions().empty()) << "in the middle of a sentence another one would come up";
  while (run.step()) continue;
  ASSERT_EQ(run.captions().size(), 1u);
  EXPECT_EQ(run.captions()[0].text, "Look at the dent");
}

TEST(ScenarioRun, AToolThatStayedDownLetsGoWhenItIsSetElsewhere) {
  Scenario scenario = ball_scenario();
  Clip first = palpation(-0.006);
  std::get<PalpateClip>(first.action).withdraw = false;
  scenario.timeline = {first, palpation(0.006)};
  ScenarioRun run(scenario);
  while (run.step()) {
    const ToolRecord& tool = run.record().tools.at(0);
    if (tool.phase == "approach") {
      EXPECT_EQ(tool.force.norm(), 0);
    }
  }
}

TEST(ScenarioRun, APalpationWithoutHoldReachesItsDepthAtTheEndOfAStep) {
  Scenario scenario = ball_scenario();
  for (const double hold : {0.0, 0.013}) {
    for (const double speed : {0.0113, 0.0247}) {
      Clip pressed = palpation(0.001);
      auto& clip = std::get<PalpateClip>(pressed.action);
      clip.speed = speed;
      clip.hold = hold;
      scenario.timeline = {pressed};
      ScenarioRun run(scenario);
      double deepest = 0, left = 0;
      while (run.step()) {
        deepest = std::max(deepest, run.record().tools.at(0).depth);
        left = run.record().tools.at(0).depth;
      }
      EXPECT_NEAR(deepest, clip.depth, 1e-15);
      EXPECT_EQ(left, 0);
    }
  }
}

TEST(ScenarioRun, APalpationMakesRoomForTheNextClipRatherThanStayUntilAStepEnds) {
  Scenario scenario = ball_scenario();
  scenario.simulation.time_step = 0.05;
  Clip first = palpation(0.001), second = first;
  auto& clip = std::get<PalpateClip>(first.action);
  clip.speed = 0.0113;
  clip.hold = 0;
  scenario.timeline = {first};
  const double way = 2 * (clip.depth + clip.standoff) / clip.speed;  // seconds, but for what the ball is off the wall
  second.start = way + 0.02;
  scenario.timeline = {first, second};
  ScenarioRun run(scenario);
  double end = 0;
  while (run.step()) end = run.time();
  EXPECT_GT(end, *second.start);
}

TEST(ScenarioRun, ClipsThatTurnOutToOverlapAreRefused) {
  Scenario scenario = ball_scenario();
  scenario.timeline = {palpation(0.001), palpation(0.002)};
  scenario.timeline[1].start = 0.5;  // the first lasts about 0.8 s
  EXPECT_THROW(ScenarioRun{scenario}, InputErrors);
  scenario.timeline[1].start = 1.5;
  EXPECT_NO_THROW(ScenarioRun{scenario});
}

TEST(ScenarioRun, AFreeBodyInStaticsIsHeldAndTheUserIsTold) {
  Scenario scenario = ball_scenario();
  scenario.bodies[0].fixed.clear();
  scenario.timeline = {palpation(0.001)};
  const auto told = [&](const char* words) {
    const std::vector<std::string> warnings = ScenarioRun(scenario).warnings();
    return std::ranges::count_if(warnings,
                                 [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
  };
  EXPECT_EQ(told("rigid motions"), 1);
  EXPECT_EQ(told("take up what the tools push and the weight"), 0);
  scenario.simulation.gravity = {0, 0, -9.81};
  EXPECT_EQ(told("take up what the tools push and the weight: it does not fall"), 1);
  scenario.bodies[0].fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}, .axes = {false, false, true}}};
  EXPECT_EQ(told("rigid motions"), 1);
  EXPECT_EQ(told("take up what the tools push and the weight"), 0) << "what is held along gravity bears it";
}

TEST(ScenarioRun, CapsThatMeetAtCornersThatNothingHoldsAreTold) {
  Scenario scenario = ball_scenario();
  scenario.bodies[0].surface =
      ShapeSource{.shape = Shape::kSemicylinder, .radius = 20e-3, .length = 40e-3, .triangles = 200};
  scenario.timeline = {Clip{.action = WaitClip{.duration = 0.1}}};
  const auto told = [&] {
    const std::vector<std::string> warnings = ScenarioRun(scenario).warnings();
    return std::ranges::count_if(
        warnings, [](const std::string& warning) { return warning.find("two of its caps meet") != std::string::npos; });
  };
  scenario.bodies[0].fixed = {{.region = AboveRegion{.axis = 2, .at = 15e-3}}};
  EXPECT_EQ(told(), 1);
  scenario.bodies[0].fixed = {{.region = GroupRegion{"base"}}};
  EXPECT_EQ(told(), 0);
}

TEST(ScenarioRun, APressureThatTheWallCannotHoldFailsWithWords) {
  Scenario scenario = ball_scenario();
  scenario.bodies[0].fluid.initial_pressure = 5000;
  try {
    ScenarioRun run(scenario);
    FAIL() << "no failure";
  } catch (const SimulationFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("under 5000 Pa"), std::string::npos) << failure.what();
  }
}

TEST(ScenarioRun, TwiceTheSameScenarioGivesTheSameDigestToTheLastBit) {
  Scenario scenario = ball_scenario();
  scenario.simulation.analysis = Analysis::kDynamic;
  scenario.tools[0] = {.name = "probe", .kind = ToolKind::kSphere, .radius = 0.004};
  scenario.timeline = {palpation(0.003)};
  std::vector<std::string> digests;
  for (int k = 0; k < 2; ++k) {
    ScenarioRun run(scenario);
    while (run.time() < 0.5 && run.step()) {
    }
    digests.push_back(run.state_digest());
  }
  EXPECT_EQ(digests[0], digests[1]);
  EXPECT_EQ(digests[0].size(), 32u);
  scenario.bodies[0].density *= 1.0001;
  ScenarioRun run(scenario);
  while (run.time() < 0.5 && run.step()) {
  }
  EXPECT_NE(run.state_digest(), digests[0]);
}

TEST(ScenarioRun, TellsThatAHeldWallHasGivenWayToANeedleWithinAStep) {
  Scenario scenario = pierced_ball(320, 400, 0.004);
  scenario.bodies[0].fixed.push_back({.region = SphereRegion{.center = {0, 0, 0.02}, .radius = 0.008}});
  ScenarioRun run(scenario);
  const std::size_t triangles = run.snapshot().surfaces.at(0).topology->triangles.size();
  std::vector<std::string> phases;
  while (run.step()) {
    const std::string& phase = run.record().tools.at(0).phase;
    if (phases.empty() || phases.back() != phase) phases.push_back(phase);
    EXPECT_LT(run.record().tools.at(0).force.norm(), 0.4 / 1.8);  // 0.4 mJ over nine tenths of a cone of 2 mm
  }
  const std::vector<std::string> in = {"approach", "contact", "rupture", "sliding"};
  EXPECT_TRUE(std::ranges::equal(in, std::span(phases).first(std::min<std::size_t>(4, phases.size()))));
  EXPECT_EQ(run.cuts(), 1);
  EXPECT_GT(run.snapshot().surfaces.at(0).topology->triangles.size(), triangles);
}

}  // namespace
}  // namespace thinwall
