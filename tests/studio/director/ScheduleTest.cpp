// Which clips may play at once, and which drives a tool.

#include "studio/director/Schedule.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "studio/director/ScenarioRun.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

constexpr const char* kStillIn = "to cut body `skin`, which blade `blade` cuts";

ToolDefinition blade(const std::string& name) {
  return {.name = name, .kind = ToolKind::kScalpel, .length = 0.012, .width = 0.003, .thickness = 4e-4};
}

InciseClip incision(const std::string& tool, double speed) {
  return {.tool = tool,
          .body = "skin",
          .path = {{-0.007, 0, 0}, {0.007, 0, 0}},
          .direction = -Eigen::Vector3d::UnitZ(),
          .depth = 0.003,
          .speed = speed,
          .standoff = 0.002};
}

/// A sheet that `blade` cuts from time zero on, and `other` from `start` on, seconds, or once the first has ended.
Scenario two_incisions(std::optional<double> start, double first_speed = 0.02) {
  BodyScenario sheet{.name = "skin",
                     .surface = ShapeSource{.shape = Shape::kSheet, .length = 0.04, .width = 0.04, .triangles = 100},
                     .thickness = {.standard = 1e-3},
                     .material = {.law = find_wall_law("neo_hookean"), .parameters = {40e3}}};
  sheet.toughness = Field<double>{.standard = 150};
  sheet.fluid.kind = FluidKind::kNone;
  sheet.fixed = {{.region = BoundaryRegion{}}};
  Scenario scenario{.name = "test", .title = "test"};
  scenario.bodies = {sheet};
  scenario.tools = {blade("blade"), blade("other")};
  scenario.simulation = {.analysis = Analysis::kDynamic, .time_step = 0.01};
  scenario.timeline = {{.action = incision("blade", first_speed)}, {.action = incision("other", 0.02), .start = start}};
  return scenario;
}

/// Why a scenario is refused before its first step; empty when it is not.
std::string refusal_of(const Scenario& scenario) {
  try {
    const ScenarioRun run(scenario);
  } catch (const InputErrors& errors) {
    return to_text(errors.diagnostics().at(0));
  }
  return "";
}

TEST(Schedule, RefusesWaysFromTheStandoffThatTakeMoreThanTenMillionSteps) {
  // 2 km at 20 mm/s: 1e5 s, and back; steps of 1 s are few enough.
  Scenario scenario = two_incisions(std::nullopt);
  scenario.timeline.pop_back();
  std::get<InciseClip>(scenario.timeline[0].action).standoff = 2000;
  EXPECT_NE(refusal_of(scenario).find("timeline[1]: the run would take 2e+07 steps, 10 million are allowed"),
            std::string::npos)
      << refusal_of(scenario);
  scenario.simulation.time_step = 1;
  EXPECT_EQ(refusal_of(scenario), "");
}

TEST(Schedule, RefusesTwoBladesThatCutOneBodyAtOnce) {
  for (const double start : {0.0, 0.05, 0.5}) {
    EXPECT_NE(refusal_of(two_incisions(start)).find(kStillIn), std::string::npos) << start;
  }
}

TEST(Schedule, RefusesABladeThatBeginsWhileAnotherOneStaysInTheBody) {
  Scenario scenario = two_incisions(std::nullopt);
  std::get<InciseClip>(scenario.timeline[0].action).withdraw = false;
  EXPECT_NE(refusal_of(scenario).find(kStillIn), std::string::npos);
  // Once it is taken elsewhere it is in the way no more.
  const MoveClip away{.tool = "blade", .to = {0, 0, 0.03}, .duration = 0.1};
  scenario.timeline.insert(scenario.timeline.begin() + 1, Clip{.action = away});
  EXPECT_EQ(refusal_of(scenario), "");
}

TEST(Schedule, LetsASecondBladeCutOnceTheFirstIsOutOrBeforeItIsIn) {
  EXPECT_EQ(refusal_of(two_incisions(std::nullopt)), "");
  EXPECT_EQ(refusal_of(two_incisions(0.0, 1e-4)), "");
}

TEST(Schedule, LetsTwoBladesCutTwoBodiesAtOnce) {
  Scenario scenario = two_incisions(0.0);
  scenario.bodies.push_back(scenario.bodies[0]);
  scenario.bodies[1].name = "other skin";
  std::get<InciseClip>(scenario.timeline[1].action).body = "other skin";
  EXPECT_EQ(refusal_of(scenario), "");
}

TEST(Schedule, AToolThatIsSetElsewhereWithinAStepTouchesNothingOnTheWay) {
  // Above the sheet, and from 5 ms after a step on below it.
  Scenario scenario = two_incisions({});
  const auto move = [](double height, double duration) {
    return Clip{.action = MoveClip{.tool = "blade",
                                   .from = Eigen::Vector3d(-0.005, 0, height),
                                   .to = {0.005, 0, height},
                                   .direction = Eigen::Vector3d(0, 0, -1),
                                   .duration = duration}};
  };
  scenario.timeline = {move(0.004, 0.055), move(-0.004, 0.05)};
  ScenarioRun run(scenario);
  while (run.step()) {
    const ToolRecord& tool = run.record().tools.at(0);
    EXPECT_EQ(tool.depth, 0) << "at " << run.time();
    EXPECT_EQ(tool.position.z(), run.time() < 0.055 ? 0.004 : -0.004);
  }
}

/// A clip that has begun and moves a tool, or none. `begin`, `end`: seconds.
ScheduledClip playing(const Clip& clip, double begin, double end) {
  ScheduledClip playing{.plan = WaitClip{}, .begin = begin, .end = end, .begun = true};
  if (const auto* move = std::get_if<MoveClip>(&clip.action)) playing.plan = plan_move(*move, {}, true);
  return playing;
}

Clip move_to(double height) {
  return {.action = MoveClip{.tool = "probe", .to = {0, 0, height}}};
}

TEST(Schedule, ClipsOfOneToolMayTouchWhicheverTheTimelineTellsFirst) {
  const std::vector<Clip> timeline = {move_to(0.02), move_to(0.03)};
  for (const bool swapped : {false, true}) {
    std::vector<ScheduledClip> clips = {playing(timeline[0], 0, 1), playing(timeline[1], 1, 2)};
    if (swapped) std::swap(clips[0], clips[1]);
    EXPECT_NO_THROW(refuse_overlaps(timeline, clips)) << swapped;
    clips[swapped ? 1 : 0].end = 1.1;
    EXPECT_THROW(refuse_overlaps(timeline, clips), InputErrors) << swapped;
  }
}

TEST(Schedule, LetsARunTakeTenMillionStepsAndNoMore) {
  const std::vector<Clip> timeline = {move_to(0.02)};
  EXPECT_NO_THROW(refuse_endless(timeline, std::vector{playing(timeline[0], 0, 1e6)}, 0.1));
  EXPECT_THROW(refuse_endless(timeline, std::vector{playing(timeline[0], 0, 1.001e6)}, 0.1), InputErrors);
}

TEST(Schedule, AClipDrivesItsToolInTheStepsThatBeginBeforeItsEnd) {
  const std::vector<Clip> timeline = {move_to(0.02)};
  const std::vector clips = {playing(timeline[0], 0, 1)};
  EXPECT_EQ(driving_clips(timeline, clips, 0.95, 1.05).count("probe"), 1u);
  EXPECT_TRUE(driving_clips(timeline, clips, 1, 1.1).empty());
}

TEST(Schedule, ForeseesMovesInTheOrderInWhichTheyPlay) {
  const std::vector<Clip> timeline = {move_to(0.05), move_to(0.02)};
  std::vector<ScheduledClip> clips = {playing(timeline[0], 3, 4), playing(timeline[1], 0, 1)};
  foresee_moves(timeline, clips);
  EXPECT_EQ(std::get<MovePlan>(clips[0].plan).begin.tip.z(), 0.02);
}

TEST(Schedule, ShowsAClipsOwnWordsOrWhatItDoesWhereNoOthersAreShown) {
  const auto shown = [](const std::optional<std::string>& own, const std::optional<std::string>& other) {
    const std::vector<Clip> timeline = {{.action = GraspClip{.tool = "grip"}, .caption = own},
                                        {.action = WaitClip{}, .caption = other}};
    std::string texts;
    for (const TimedText& text :
         texts_of(timeline, std::vector{playing(timeline[0], 0, 2), playing(timeline[1], 1, 3)}, false)) {
      texts += text.text + ".";
    }
    return texts;
  };
  EXPECT_EQ(shown({}, {}), "Grasping.");
  EXPECT_EQ(shown({}, "Rest"), "Rest.");
  EXPECT_EQ(shown({}, ""), "Grasping.") << "no words are in no other's way";
  EXPECT_EQ(shown("", {}), "") << "a clip may be without words";
  EXPECT_EQ(shown("Grip", "Rest"), "Grip.Rest.");
}

TEST(Schedule, TellsWordsInTheOrderOfTheirTimes) {
  const std::vector<Clip> timeline = {{.action = WaitClip{}, .caption = "late"},
                                      {.action = WaitClip{}, .caption = "early"}};
  const auto texts = texts_of(timeline, std::vector{playing(timeline[0], 5, 6), playing(timeline[1], 0, 1)}, false);
  ASSERT_EQ(texts.size(), 2u);
  EXPECT_EQ(texts[0].text, "early");
  EXPECT_EQ(texts[1].text, "late");
}

}  // namespace
}  // namespace thinwall
