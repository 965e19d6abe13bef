#include "studio/recorder/FrameComposer.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "tests/studio/SyntheticRun.hpp"

namespace thinwall {
namespace {

FrameComposer fed_up_to(const SyntheticRun& run, std::size_t step) {
  FrameComposer composer("A sheet", {});
  for (std::size_t i = 0; i <= step; ++i) composer.add(run.moment(i));
  return composer;
}

TEST(FrameComposerTest, AFrameLiesBetweenItsNeighbours) {
  const SyntheticRun run;
  const Frame frame = fed_up_to(run, 8).compose(0.0375);
  EXPECT_DOUBLE_EQ(frame.snapshot.time, 0.0375);
  const double mean = 0.5 * (run.moment(7).snapshot.tools[0].depth + run.moment(8).snapshot.tools[0].depth);
  EXPECT_DOUBLE_EQ(frame.overlay.depth, mean);
  EXPECT_DOUBLE_EQ(frame.overlay.force, 100 * mean);
  ASSERT_TRUE(frame.overlay.pressure);
  EXPECT_DOUBLE_EQ(*frame.overlay.pressure, 1e5 * mean);
}

TEST(FrameComposerTest, ACameraThatGoesRoundKnowsWhenTheRecordingEnds) {
  ViewDefinition view;
  view.camera.orbit_speed = 0.4;
  Moment moment = SyntheticRun().moment(0);
  moment.planned_duration = 3;
  FrameComposer composer("", {}, view);
  composer.add(moment);
  EXPECT_EQ(composer.compose(0).shot.camera.orbit_end, 3);
}

TEST(FrameComposerTest, InsetAndLegendStandInTheSameCornersInAllFrames) {
  const SyntheticRun run;
  ViewDefinition view;
  view.camera = {.position = Double3{0, 0, 0.2}, .target = Double3{0, 0, 0}, .up = Double3{0, 1, 0}};
  view.cuts = {{.time = 0, .inset = "main"}};
  view.look.data = DataView{.from = 0, .to = 1, .legend = PictureCorner::kLowerRight};
  // In the upper right of the picture, at the very end, when all but the last frames have been drawn.
  const PlannedWork work{.places = {{0.07, 0.03, 0}}, .begin = 1e3, .end = 2e3};
  FrameComposer composer("", {}, view, {}, {.size = {1280, 720}, .work = {work}});
  Moment first = run.moment(0);
  first.planned_duration = 2e3;
  composer.add(first);
  for (std::size_t step = 1; step < 4; ++step) {
    composer.add(run.moment(step));
    const Frame frame = composer.compose(run.moment(step).snapshot.time);
    EXPECT_EQ(frame.shot.corner, PictureCorner::kUpperLeft);
    ASSERT_TRUE(frame.overlay.legend);
    EXPECT_EQ(frame.overlay.legend->corner, PictureCorner::kLowerRight);
  }
}

TEST(FrameComposerTest, TellsThePressureOfTheFirstBodyThatHasContents) {
  Moment moment = SyntheticRun().moment(0);
  SnapshotSurface organ = moment.snapshot.surfaces[0];
  moment.snapshot.surfaces[0].body = "sheet";
  organ.body = "organ";
  moment.snapshot.scalars = {{"sheet.pressure", "Pa", 0}, {"sheet.volume", "m^3", 0}};
  FrameComposer open("", {});
  open.add(moment);
  EXPECT_FALSE(open.compose(0).overlay.pressure) << "an open sheet has none";
  moment.snapshot.surfaces.push_back(organ);
  moment.snapshot.scalars.push_back({"organ.pressure", "Pa", 700});
  moment.snapshot.scalars.push_back({"organ.volume", "m^3", 1e-5});
  FrameComposer both("", {});
  both.add(moment);
  EXPECT_EQ(both.compose(0).overlay.pressure, 700);
  EXPECT_EQ(both.compose(0).overlay.pressurized_body, "") << "it can be no other's";
}

TEST(FrameComposerTest, OfSeveralBodiesWithContentsThePressureIsThatOfTheOneThatTheToolIsAtAndSaysWhose) {
  Moment moment = SyntheticRun().moment(0);
  SnapshotSurface other = moment.snapshot.surfaces[0];
  moment.snapshot.surfaces[0].body = "cyst";
  other.body = "vessel";
  for (Float3& position : other.positions) position[0] += 1;
  moment.snapshot.surfaces.push_back(other);
  moment.snapshot.scalars = {{"cyst.pressure", "Pa", 800}, {"vessel.pressure", "Pa", 3000}};
  for (const auto& [at, pressure, body] : {std::tuple{0.0, 800.0, "cyst"}, {1.0, 3000.0, "vessel"}}) {
    moment.snapshot.tools[0].tip[0] = at;
    FrameComposer composer("", {});
    composer.add(moment);
    EXPECT_EQ(composer.compose(0).overlay.pressure, pressure) << "tool at " << at << " m";
    EXPECT_EQ(composer.compose(0).overlay.pressurized_body, body);
  }
  moment.snapshot.tools.clear();
  FrameComposer without("", {});
  without.add(moment);
  EXPECT_EQ(without.compose(0).overlay.pressure, 800) << "the first one's without a tool";
}

TEST(FrameComposerTest, PressureAndExpectedForceAreThoseOfTheBodyThatIsNotScenery) {
  Moment moment = SyntheticRun().moment(0);
  FrameComposer alone("", {});
  alone.add(moment);
  SnapshotSurface bed = moment.snapshot.surfaces[0];
  bed.body = "bed";
  auto scenery = std::make_shared<SnapshotTopology>(*bed.topology);
  scenery->is_scenery = true;
  for (float& thickness : scenery->thickness) thickness *= 10;
  bed.topology = scenery;
  const std::string organ = moment.snapshot.surfaces[0].body;
  moment.snapshot.surfaces.insert(moment.snapshot.surfaces.begin(), bed);
  moment.snapshot.scalars = {{"bed.pressure", "Pa", 0}, {"bed.volume", "m^3", 1e-4}, {organ + ".pressure", "Pa", 700}};
  FrameComposer in_bed("", {});
  in_bed.add(moment);
  EXPECT_EQ(in_bed.compose(0).overlay.pressure, 700);
  EXPECT_EQ(in_bed.compose(0).overlay.expected_force, alone.compose(0).overlay.expected_force);
  moment.snapshot.surfaces.pop_back();
  FrameComposer bed_alone("", {});
  bed_alone.add(moment);
  EXPECT_EQ(bed_alone.compose(0).overlay.pressure, 0) << "where all is scenery it has a pressure, too";
  EXPECT_GT(bed_alone.compose(0).overlay.expected_force, alone.compose(0).overlay.expected_force);
}

TEST(FrameComposerTest, ForcesOfSmallBodiesAreExpectedToBeSmall) {
  Moment moment = SyntheticRun().moment(0);
  FrameComposer large("", {});
  large.add(moment);
  EXPECT_GT(large.compose(0).overlay.expected_force, 0.1);
  auto small = std::make_shared<SnapshotTopology>(*moment.snapshot.surfaces[0].topology);
  for (Float3& position : small->rest_positions) {
    for (float& part : position) part /= 50;
  }
  for (float& thickness : small->thickness) thickness /= 50;
  moment.snapshot.surfaces[0].topology = small;
  FrameComposer tiny("", {});
  tiny.add(moment);
  EXPECT_NEAR(tiny.compose(0).overlay.expected_force, large.compose(0).overlay.expected_force / 2500, 1e-6);
}

TEST(FrameComposerTest, OfSeveralToolsTheOneThatTouchesIsShownElseTheLastThatDid) {
  const SyntheticRun run;
  FrameComposer composer("", {});
  auto shown_after = [&, step = std::size_t{0}](const std::string& first, double first_force, const std::string& second,
                                                double second_force) mutable {
    Moment moment = run.moment(step++);
    SnapshotTool tool = moment.snapshot.tools[0];
    tool.name = "first";
    tool.phase = first;
    tool.force = {0, 0, first_force};
    moment.snapshot.tools = {tool, tool};
    moment.snapshot.tools[1].name = "second";
    moment.snapshot.tools[1].phase = second;
    moment.snapshot.tools[1].force = {0, 0, second_force};
    const double time = moment.snapshot.time;
    composer.add(std::move(moment));
    return composer.compose(time).overlay.tool;
  };
  EXPECT_EQ(shown_after("idle", 0, "approach", 0), "second") << "nothing has touched";
  EXPECT_EQ(shown_after("approach", 0, "contact", 1), "second");
  EXPECT_EQ(shown_after("approach", 0, "withdrawal", 0), "second") << "the last that touched";
  EXPECT_EQ(shown_after("contact", 1, "withdrawal", 0), "first");
  EXPECT_EQ(shown_after("idle", 0, "approach", 0), "first");
}

TEST(FrameComposerTest, OfToolsThatTouchTheOneThatSetOutLastIsShown) {
  FrameComposer composer("", {});
  auto shown_after = [&, time = 0.0](const char* left, const char* acting) mutable {
    Moment moment;
    moment.snapshot.time = time++;
    moment.snapshot.tools = {{.name = "left", .phase = left, .force = {0, 0, 1}},
                             {.name = "acting", .phase = acting, .force = {0, 0, *acting == 'i' ? 0.0 : 1.0}}};
    composer.add(moment);
    return composer.compose(moment.snapshot.time).overlay.tool;
  };
  EXPECT_EQ(shown_after("contact", "idle"), "left");
  EXPECT_EQ(shown_after("hold", "idle"), "left");
  EXPECT_EQ(shown_after("hold", "contact"), "acting") << "the first was left in the wall";
  EXPECT_EQ(shown_after("hold", "withdrawal"), "acting");
  EXPECT_EQ(shown_after("contact", "hold"), "left") << "it has set out again";
}

TEST(FrameComposerTest, AToolThatIsOutOfThePictureGivesWayToTheOneThatSetOutLast) {
  FrameComposer composer("", {});
  auto shown_after = [&, time = 0.0](const char* first, double force, const char* second, const char* third) mutable {
    Moment moment;
    moment.snapshot.time = time++;
    moment.snapshot.tools = {{.name = "first", .phase = first, .force = {0, 0, force}},
                             {.name = "second", .phase = second},
                             {.name = "third", .phase = third}};
    composer.add(moment);
    return composer.compose(moment.snapshot.time).overlay.tool;
  };
  EXPECT_EQ(shown_after("contact", 1, "idle", "idle"), "first");
  EXPECT_EQ(shown_after("withdrawal", 0, "idle", "idle"), "first");
  EXPECT_EQ(shown_after("withdrawal", 0, "approach", "idle"), "first") << "it is seen until it is back";
  EXPECT_EQ(shown_after("idle", 0, "approach", "idle"), "second");
  EXPECT_EQ(shown_after("idle", 0, "approach", "approach"), "third");
}

TEST(FrameComposerTest, EachToolThatHasTouchedHasAHistoryAndKeepsItsNumber) {
  const auto moment = [](double time, double first, double second) {
    Moment result;
    result.snapshot.time = time;
    result.snapshot.tools = {{.name = "probe", .phase = "contact", .force = {0, 0, first}},
                             {.name = "needle", .phase = "contact", .force = {0, second, 0}}};
    return result;
  };
  FrameComposer composer("", {});
  composer.add(moment(0, 0, 0));
  composer.add(moment(1, 3, 0));
  EXPECT_EQ(composer.compose(1).overlay.tool_number, 0U);
  EXPECT_TRUE(composer.compose(1).overlay.other_tools.empty()) << "the needle has not touched";
  composer.add(moment(2, 0, 5));
  const OverlayContent content = composer.compose(2).overlay;
  EXPECT_EQ(content.tool, "needle");
  EXPECT_EQ(content.tool_number, 1U);
  ASSERT_EQ(content.other_tools.size(), 1U);
  EXPECT_EQ(content.other_tools[0].tool, "probe");
  EXPECT_EQ(content.other_tools[0].number, 0U);
  ASSERT_EQ(content.other_tools[0].samples.size(), 3U);
  EXPECT_EQ(content.other_tools[0].samples[1].force, 3);
}

TEST(FrameComposerTest, ToolsThatWaitAreOutOfThePictureFromWhenAnotherBegins) {
  FrameComposer composer("", {});
  auto drawn_after = [&, time = 0.0](const std::vector<const char*>& phases) mutable {
    Moment moment;
    moment.snapshot.time = time++;
    for (const char* phase : phases) moment.snapshot.tools.push_back({.name = "tool", .phase = phase});
    composer.add(moment);
    std::string drawn;
    for (const SnapshotTool& tool : composer.compose(moment.snapshot.time).snapshot.tools) {
      drawn += tool.is_set_aside ? '-' : 'x';
    }
    return drawn;
  };
  EXPECT_EQ(drawn_after({"idle", "idle", "idle"}), "xxx");
  EXPECT_EQ(drawn_after({"approach", "idle", "idle"}), "x--") << "their clips are still to come";
  EXPECT_EQ(drawn_after({"withdrawal", "idle", "idle"}), "x--");
  EXPECT_EQ(drawn_after({"idle", "idle", "idle"}), "x--");
  EXPECT_EQ(drawn_after({"idle", "approach", "idle"}), "-x-") << "the first has gone back";
  EXPECT_EQ(drawn_after({"hold", "cutting", "idle"}), "xx-") << "a wall touches the first";
  EXPECT_EQ(drawn_after({"idle", "hold", "idle"}), "-x-");
  EXPECT_EQ(drawn_after({"idle", "idle", "approach"}), "-xx") << "the second was left where it is";
  EXPECT_EQ(drawn_after({"idle", "withdrawal", "cutting"}), "-xx");
  EXPECT_EQ(composer.compose(7.5).snapshot.tools[1].is_set_aside, false);
}

TEST(FrameComposerTest, ForcepsThatLetGoStayWhereTheyAreAndSetAsideWhatHasGoneBack) {
  FrameComposer composer("", {});
  auto drawn_after = [&, time = 0.0](const char* forceps, double opening, double height, const char* blade) mutable {
    Moment moment;
    moment.snapshot.time = time++;
    moment.snapshot.tools = {{.name = "forceps", .opening = opening, .tip = {0, 0, height}, .phase = forceps},
                             {.name = "blade", .phase = blade}};
    composer.add(moment);
    const Snapshot drawn = composer.compose(moment.snapshot.time).snapshot;
    return std::string(drawn.tools[0].is_set_aside ? "-" : "x") + (drawn.tools[1].is_set_aside ? "-" : "x");
  };
  drawn_after("approach", 8e-3, 5e-3, "idle");
  drawn_after("hold", 1e-3, 0, "idle");
  EXPECT_EQ(drawn_after("hold", 1e-3, 0, "cutting"), "xx");
  EXPECT_EQ(drawn_after("hold", 1e-3, 0, "withdrawal"), "xx");
  EXPECT_EQ(drawn_after("withdrawal", 3e-3, 0, "idle"), "x-") << "the jaws open, which is the forceps' clip";
  EXPECT_EQ(drawn_after("idle", 8e-3, 0, "idle"), "x-");
  EXPECT_EQ(composer.compose(5).overlay.tool, "forceps");
  EXPECT_EQ(drawn_after("idle", 8e-3, 0, "cutting"), "xx") << "nothing has taken them away";
}

TEST(FrameComposerTest, ToolsGoOutOfThePictureAtTheMomentAtWhichAnotherHasBegun) {
  FrameComposer composer("", {});
  for (const char* phase : {"idle", "approach"}) {
    Moment moment;
    moment.snapshot.time = *phase == 'i' ? 0 : 1;
    moment.snapshot.tools = {{.name = "waits", .phase = "idle"}, {.name = "works", .phase = phase}};
    composer.add(std::move(moment));
  }
  EXPECT_FALSE(composer.compose(0.5).snapshot.tools[0].is_set_aside);
  EXPECT_TRUE(composer.compose(1).snapshot.tools[0].is_set_aside);
}

TEST(FrameComposerTest, KnowsHowFarItReaches) {
  const SyntheticRun run;
  EXPECT_FALSE(FrameComposer("", {}).reaches(0));
  EXPECT_TRUE(fed_up_to(run, 0).reaches(0));
  EXPECT_FALSE(fed_up_to(run, 6).reaches(1 / 30.0));
  EXPECT_TRUE(fed_up_to(run, 7).reaches(1 / 30.0));
  // Sums of time steps miss multiples of a frame's time by rounding.
  EXPECT_TRUE(fed_up_to(run, 7).reaches(0.035 + 1e-12));
}

TEST(FrameComposerTest, TheHistoryEndsWithTheFrame) {
  const Frame frame = fed_up_to(SyntheticRun(), 8).compose(0.0375);
  ASSERT_EQ(frame.overlay.history.size(), 9U);
  EXPECT_DOUBLE_EQ(frame.overlay.history[7].time, 0.035);
  EXPECT_DOUBLE_EQ(frame.overlay.history[8].time, 0.0375);
  EXPECT_DOUBLE_EQ(frame.overlay.history[8].force, frame.overlay.force);
}

TEST(FrameComposerTest, CaptionsHoldFromAfterTheirBeginToTheirEndAndThatOfTimeZeroAtOnce) {
  const SyntheticRun run;
  EXPECT_EQ(fed_up_to(run, 0).compose(0).overlay.caption, "Pressing");
  EXPECT_EQ(fed_up_to(run, 1).compose(0.001).overlay.caption, "Pressing");
  EXPECT_EQ(fed_up_to(run, 20).compose(0.1).overlay.caption, "Pressing");
  EXPECT_EQ(fed_up_to(run, 21).compose(0.1001).overlay.caption, "Releasing");
  EXPECT_EQ(fed_up_to(run, 40).compose(0.2).overlay.caption, "Releasing");
}

TEST(FrameComposerTest, AClipThatIsKnownLaterChangesNoEarlierFrame) {
  const SyntheticRun run;
  Moment live = run.moment(20);
  live.captions.pop_back();  // the second begins at this very time
  FrameComposer composer("A sheet", {});
  for (std::size_t i = 0; i < 20; ++i) composer.add(run.moment(i));
  composer.add(live);
  EXPECT_EQ(composer.compose(0.1).overlay.caption, fed_up_to(run, 20).compose(0.1).overlay.caption);
}

TEST(FrameComposerTest, KeepsShowingTheToolThatWasLastActive) {
  const auto moment = [](double time, const std::string& first, const std::string& second) {
    Moment result;
    result.snapshot.time = time;
    result.snapshot.tools = {{.name = "probe", .phase = first}, {.name = "needle", .phase = second}};
    return result;
  };
  FrameComposer composer("", {});
  composer.add(moment(0, "idle", "idle"));
  EXPECT_EQ(composer.compose(0).overlay.tool, "probe");
  composer.add(moment(1, "idle", "contact"));
  composer.add(moment(2, "idle", "idle"));
  EXPECT_EQ(composer.compose(1.5).overlay.tool, "needle");
  composer.add(moment(3, "approach", "idle"));
  EXPECT_EQ(composer.compose(2.5).overlay.tool, "needle");
  composer.add(moment(4, "approach", "idle"));
  EXPECT_EQ(composer.compose(3.5).overlay.tool, "probe");
}

TEST(FrameComposerTest, WithoutToolsThereIsNoForceToShow) {
  Moment moment;
  FrameComposer composer("", {});
  composer.add(moment);
  const Frame frame = composer.compose(0);
  EXPECT_FALSE(frame.overlay.shown.force_plot);
  EXPECT_FALSE(frame.overlay.shown.gauge);
  EXPECT_TRUE(frame.overlay.shown.time);
}

TEST(FrameComposerTest, OverlaysCanBeChosen) {
  FrameComposer composer("", {.force_plot = false, .gauge = true, .captions = false, .time = false});
  composer.add(SyntheticRun().moment(0));
  const OverlayContent overlay = composer.compose(0).overlay;
  EXPECT_FALSE(overlay.shown.force_plot);
  EXPECT_TRUE(overlay.shown.gauge);
  EXPECT_FALSE(overlay.shown.captions);
  EXPECT_FALSE(overlay.shown.time);
}

}  // namespace
}  // namespace thinwall
