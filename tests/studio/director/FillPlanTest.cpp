#include "studio/director/FillPlan.hpp"

#include <gtest/gtest.h>

#include "studio/director/Plan.hpp"
#include "studio/director/ScenarioRun.hpp"
#include "studio/scenario/InputError.hpp"
#include "tests/studio/director/HeldBall.hpp"

namespace thinwall {
namespace {

Scenario filled_ball_scenario() {
  return held_ball(80, 0.03);
}

Clip fill(double added, std::optional<double> pressure = {}) {
  return {.action = FillClip{.body = "ball", .added = added, .pressure = pressure, .duration = 0.1}};
}

BodyRecord last_record(const Scenario& scenario, double until = 1e9) {
  ScenarioRun run(scenario);
  while (run.time() < until && run.step()) continue;
  return run.record().bodies.at(0);
}

TEST(FillPlan, WhatIsFilledInAddsUpWhateverTheStep) {
  // Steps of 30 ms do not end with clips of 100 ms.
  Scenario scenario = filled_ball_scenario();
  scenario.timeline = {fill(2e-6), fill(-0.5e-6), {.action = WaitClip{0.2}}};
  const double start = ScenarioRun(scenario).record().bodies.at(0).fluid_volume;
  const BodyRecord record = last_record(scenario);
  EXPECT_NEAR(record.fluid_volume - start, 1.5e-6, 1e-17);
  EXPECT_GT(record.pressure, 200);
}

TEST(FillPlan, APressureIsReachedAndThenTheVolumeIsKept) {
  Scenario scenario = filled_ball_scenario();
  scenario.timeline = {fill(0, 500), {.action = WaitClip{0.2}}};
  EXPECT_NEAR(last_record(scenario, 0.119).pressure, 500, 1e-6);
  EXPECT_NEAR(last_record(scenario).pressure, 500, 1e-6);
  EXPECT_NEAR(last_record(scenario, 0.059).pressure, 200 + 300 * 0.6, 1e-6);
}

TEST(FillPlan, ABodyWithoutFluidOrChamberOfThatNameIsRefused) {
  Scenario scenario = filled_ball_scenario();
  Clip clip = fill(1e-6);
  std::get<FillClip>(clip.action).chamber = "left";
  clip.number = 2;
  scenario.timeline = {clip};
  try {
    ScenarioRun run(scenario);
    FAIL() << "filled what is not there";
  } catch (const InputErrors& refusal) {
    EXPECT_EQ(refusal.diagnostics().at(0).message, "timeline[2].inflate: the body `ball` has no chamber `left`");
  }
  scenario.timeline = {fill(1e-6)};
  scenario.bodies[0].fluid = {.kind = FluidKind::kNone};
  EXPECT_THROW(ScenarioRun{scenario}, InputErrors);
}

TEST(FillPlan, MoreThanTheContentsCannotBeDrained) {
  Scenario scenario = filled_ball_scenario();
  scenario.timeline = {fill(0)};
  const double held = ScenarioRun(scenario).record().bodies.at(0).fluid_volume;
  scenario.timeline = {fill(-0.9 * held), fill(0.3 * held), fill(-0.3 * held)};
  EXPECT_NO_THROW(ScenarioRun{scenario});
  scenario.timeline.back() = fill(-0.41 * held);
  scenario.timeline.back().location.line = 7;
  try {
    ScenarioRun run(scenario);
    FAIL() << "drained more than there is";
  } catch (const InputErrors& refusal) {
    ASSERT_EQ(refusal.diagnostics().size(), 1U);
    EXPECT_EQ(refusal.diagnostics()[0].location.line, 7);
    EXPECT_TRUE(refusal.diagnostics()[0].message.starts_with("timeline[3].drain: ")) << refusal.what();
    EXPECT_NE(refusal.diagnostics()[0].message.find("body `ball` holds"), std::string::npos) << refusal.what();
  }
  scenario.timeline = {fill(-held)};
  EXPECT_THROW(ScenarioRun{scenario}, InputErrors) << "nothing would be left";
  // The order is that of time; after a pressure has been reached the volume is not known beforehand.
  scenario.timeline = {fill(-0.9 * held), fill(1.5 * held)};
  scenario.timeline[0].start = 0.1;
  scenario.timeline[1].start = 0;
  EXPECT_NO_THROW(ScenarioRun{scenario});
  scenario.timeline = {fill(0, 500), fill(-1.1 * held)};
  EXPECT_NO_THROW(ScenarioRun{scenario});
}

TEST(FillPlan, LoadsFollowTheirPointsStraightAndEvenBeyondThem) {
  BodyScenario body;
  body.loads = {{.over = {{1, 0}, {2, 1}, {4, -1}}}, {}};
  EXPECT_EQ(load_factors(body, 0), (std::vector<double>{0, 1}));
  EXPECT_EQ(load_factors(body, 1.5), (std::vector<double>{0.5, 1}));
  EXPECT_EQ(load_factors(body, 3), (std::vector<double>{0, 1}));
  EXPECT_EQ(load_factors(body, 9), (std::vector<double>{-1, 1}));
}

TEST(FillPlan, LoadsActInARunAndAreBookedAsTheScripts) {
  Scenario scenario = filled_ball_scenario();
  scenario.bodies[0].loads = {
      {.load = {.kind = LoadKind::kDeadForce, .region = AboveRegion{.axis = 2, .at = 0.015}, .vector = {0, 0, 0.02}},
       .over = {{0, 0}, {0.2, 1}}}};
  scenario.timeline = {{.action = WaitClip{0.3}}};
  const double before = ScenarioRun(scenario).record().bodies.at(0).script_work;
  const BodyRecord record = last_record(scenario);
  EXPECT_GT(record.script_work, before);
  EXPECT_NEAR(record.elastic + record.numerical, record.script_work, 1e-9 * record.script_work);
}

TEST(FillCaption, TellsALitreWithAllItsDigits) {
  EXPECT_EQ(standard_caption({.action = FillClip{.added = 1.2e-3, .duration = 1200}}), "Filling: 1200 ml in 1200 s");
  EXPECT_EQ(standard_caption({.action = FillClip{.added = -2.5e-7}}), "Draining: 0.25 ml in 1 s");
}

}  // namespace
}  // namespace thinwall
