#include "studio/director/RunNotes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "studio/director/ScenarioRun.hpp"
#include "tests/studio/director/HeldBall.hpp"

namespace thinwall {
namespace {

bool tells(const ScenarioRun& run, const std::string& words) {
  const std::vector<std::string> warnings = run.warnings();
  return std::ranges::any_of(warnings, [&](const std::string& one) { return one.find(words) != std::string::npos; });
}

const PalpateClip kTouch = {.tool = "finger", .body = "ball", .at = {0, 0, 0.02}, .depth = 1e-5};

Scenario touched_ball() {
  Scenario scenario = held_ball(80, 0.02);
  scenario.tools = {{.name = "finger", .kind = ToolKind::kSphere, .radius = 0.003}};
  return scenario;
}

TEST(RunNotes, TellThatANeedleHasGoneItsDepthWithoutPiercing) {
  for (const double toughness : {1.0, 1e5}) {
    ScenarioRun run(pierced_ball(80, toughness, 0.002));
    EXPECT_FALSE(tells(run, "no wall has given way")) << "before it has";
    while (run.step()) {
    }
    EXPECT_EQ(tells(run, "timeline[1]: needle `needle` has gone its whole depth of 2 mm and no wall has given way"),
              run.cuts() == 0);
    EXPECT_EQ(run.cuts() == 0, toughness > 1e3);
  }
}

TEST(RunNotes, TellOfWallsThatAreThickerThanAToolOrTheBodyHasRoomFor) {
  for (const double thickness : {1e-3, 4e-3, 21e-3}) {
    Scenario scenario = touched_ball();
    scenario.bodies[0].thickness = {.standard = thickness};
    scenario.timeline = {{.action = kTouch}, {.action = kTouch}};
    const ScenarioRun run(scenario);
    EXPECT_EQ(tells(run, "tool `finger` has a radius of 3 mm, less than the wall of body `ball` is thick"),
              thickness > 0.003);
    EXPECT_EQ(tells(run, "less than two walls of 21 mm"), thickness > 0.02);
    EXPECT_LE(run.warnings().size(), 3U) << "each once, and the shape's";
  }
}

TEST(RunNotes, TellThatAPalpationComesFromTheSideAwayFromItsPoint) {
  Scenario scenario = touched_ball();
  const auto note_with = [&](const Eigen::Vector3d& at, double sense) {
    PalpateClip clip = kTouch;
    clip.at = at;
    clip.direction = {0, 0, sense};
    scenario.timeline = {{.action = clip}};
    return tells(ScenarioRun(scenario), "and `at` is on its other side");
  };
  EXPECT_TRUE(note_with({0, 0, 0.02}, 1));
  EXPECT_TRUE(note_with({0, 0, 0.05}, 1)) << "farther off on that side";
  EXPECT_FALSE(note_with({0, 0, 0.02}, -1));
  EXPECT_FALSE(note_with({0, 0, 0}, 1)) << "a point within the body is on no side";
  EXPECT_FALSE(note_with({0, 0, 0.05}, -1)) << "before the body";
  std::get<ShapeSource>(scenario.bodies[0].surface).placed = SurfacePlacement{.at = {0, 0, 0.02}};
  scenario.bodies[0].fixed = {{.region = BelowRegion{.axis = 2, .at = 0.01}}};
  EXPECT_TRUE(note_with({0, 0, -0.001}, -1));
  EXPECT_FALSE(note_with({0, 0, 0}, -1)) << "the origin is what nobody may have given";
}

TEST(RunNotes, TellThatAToolIsInTheWallBeforeTheFirstStep) {
  // The pressure has raised the crown to 20.3 mm.
  for (const double height : {0.021, 0.0185}) {
    Scenario scenario = touched_ball();
    scenario.timeline = {{.action = MoveClip{.tool = "finger",
                                             .from = Eigen::Vector3d(0, 0, height),
                                             .to = {0, 0, 0.03},
                                             .direction = Eigen::Vector3d(0, 0, -1)}}};
    const ScenarioRun run(scenario);
    EXPECT_EQ(tells(run, "mm deep in the wall of body `ball` before the first step"), height < 0.02);
  }
}

TEST(RunNotes, TellOfAWallThatWouldBuckleWhereAMotionBegins) {
  // Strips that are pressed and pulled along themselves: as membranes they have no shape to buckle to.
  for (const double pull : {-0.002, 0.002}) {
    Scenario scenario = held_ball(80, 0.02);
    scenario.simulation.analysis = Analysis::kDynamic;
    BodyScenario& strip = scenario.bodies[0];
    strip.surface = ShapeSource{.shape = Shape::kSheet, .length = 0.1, .width = 0.02, .triangles = 250};
    strip.material = {.law = find_wall_law("st_venant_kirchhoff"), .parameters = {1e6, 0}};
    strip.fluid = {.kind = FluidKind::kNone};
    const Region end = PlaneRegion{.axis = 1, .at = 0.05};
    strip.fixed = {{.region = PlaneRegion{.axis = 1, .at = -0.05}}, {.region = end, .axes = {true, false, true}}};
    strip.loads = {{.load = {.kind = LoadKind::kDeadForce, .region = end, .vector = {0, pull, 0}}}};
    const ScenarioRun run(scenario);
    EXPECT_EQ(tells(run, "body `ball`: its equilibrium before time zero is not stable"), pull < 0);
  }
}

TEST(RunNotes, TellThatInflatingDrainsOrDrainingFills) {
  const auto told = [](double pressure, bool drains) {
    Scenario scenario = held_ball(80, 0.02);
    scenario.timeline = {
        {.action = FillClip{.body = "ball", .pressure = pressure, .drains = drains, .duration = 0.04}}};
    ScenarioRun run(scenario);
    run.step();
    return std::pair(tells(run, "timeline[1]: inflate to 100 Pa drains body `ball`, whose pressure is 200 Pa"),
                     tells(run, "timeline[1]: drain to 300 Pa fills body `ball`"));
  };
  EXPECT_EQ(told(100, false), std::pair(true, false));
  EXPECT_EQ(told(300, true), std::pair(false, true));
  EXPECT_EQ(told(300, false), std::pair(false, false));
  EXPECT_EQ(told(100, true), std::pair(false, false));
}

TEST(RunNotes, AdviseToStretchAMembraneThatNothingStretches) {
  const auto advice_of = [](const auto& change) {
    Scenario scenario = touched_ball();
    scenario.bodies[0].fluid.initial_pressure.reset();
    change(scenario.bodies[0]);
    return slack_wall_advice(scenario);
  };
  EXPECT_EQ(advice_of([](BodyScenario&) {}).rfind("; body `ball` is a membrane that nothing stretches", 0), 0u);
  EXPECT_FALSE(advice_of([](BodyScenario& body) { body.fluid.initial_pressure = 0; }).empty());
  EXPECT_EQ(advice_of([](BodyScenario& body) { body.fluid.initial_pressure = 300; }), "");
  EXPECT_EQ(advice_of([](BodyScenario& body) { body.prestretch.standard.first = 1.1; }), "");
  EXPECT_EQ(advice_of([](BodyScenario& body) { body.model = WallModel::kShell; }), "");
  EXPECT_EQ(advice_of([](BodyScenario& body) { body.fluid.kind = FluidKind::kNone; }), "")
      << "of a sheet it is its border that holds it";
  EXPECT_EQ(advice_of([](BodyScenario& body) { body.fixed = {{.region = WholeRegion{}}}; }), "");
  EXPECT_FALSE(advice_of([](BodyScenario& body) {
                 body.fixed = {{.region = WholeRegion{}, .axes = {true, true, false}}};
               }).empty());
}

}  // namespace
}  // namespace thinwall
