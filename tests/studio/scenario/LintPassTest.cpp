#include "studio/scenario/LintPass.hpp"

#include <gtest/gtest.h>

#include "studio/scenario/ClipTimes.hpp"
#include "tests/studio/scenario/CheckedText.hpp"

namespace thinwall {
namespace {

using Texts = std::vector<std::string>;

Texts errors_of(const CheckedValue& root) {
  Diagnostics diagnostics;
  lint_pass(root, diagnostics);
  return short_texts(diagnostics.errors);
}

Texts timeline_errors(const std::string& clips) {
  return errors_of(checked_scenario("timeline:\n" + clips));
}

TEST(LintPass, ClipsOfOneToolThatCertainlyOverlapAreErrors) {
  EXPECT_EQ(timeline_errors("  - move: { tool: probe, to: [0, 0, 0], for: 2 s }\n"
                            "  - move: { tool: probe, to: [0, 0, 0], start: 1.9 s }\n"),
            Texts{"10:5: timeline[2].move: drives `probe` while timeline[1].move in line 9 still does"});
}

TEST(LintPass, ClipsOfTwoToolsOrOneAfterTheOtherDoNotOverlap) {
  EXPECT_EQ(timeline_errors("  - move: { tool: probe, to: [0, 0, 0], for: 2 s }\n"
                            "  - move: { tool: edge, to: [0, 0, 0], start: 0 }\n"
                            "  - move: { tool: probe, to: [0, 0, 0], start: 2 s }\n"
                            "  - wait: { start: 0 }\n"),
            Texts{});
  EXPECT_EQ(timeline_errors("  - move: { tool: probe, to: [0, 0, 0], for: 0.1 s }\n"
                            "  - move: { tool: probe, to: [0, 0, 0], for: 0.2 s }\n"
                            "  - move: { tool: probe, to: [0, 0, 0], start: 0.3 s }\n"),
            Texts{});
}

TEST(LintPass, APalpationLastsAtLeastItsTravelAndHold) {
  const std::string palpation = "  - palpate: { tool: probe, body: organ, depth: 10 mm, speed: 10 mm/s, hold: 1 s }\n";
  const std::string move = "  - move: { tool: probe, to: [0, 0, 0], start: ";
  EXPECT_EQ(timeline_errors(palpation + move + "2.9 s }\n").size(), 1U);
  EXPECT_EQ(timeline_errors(palpation + move + "3.1 s }\n").size(), 0U);
}

TEST(LintPass, AClipAfterAPalpationBeginsAtAnUnknownTime) {
  const std::vector<ClipTimes> clips = clip_times(
      checked_scenario("timeline: [ wait: { for: 2 s }, palpate: { tool: probe, depth: 1 mm }, wait: {} ]\n"));
  EXPECT_EQ(clips[1].start, 2.0);
  EXPECT_FALSE(clips[1].end);
  EXPECT_FALSE(clips[2].start);
  EXPECT_FALSE(end_of_timeline(clips));
}

TEST(LintPass, RunsOfMoreThanTenMillionStepsAreErrorsOfTheStepOrOfTheClip) {
  EXPECT_EQ(errors_of(checked_scenario("timeline: [ wait: { for: 2 s } ]\n"
                                       "simulation: { time_step: 1e-15 s }\n")),
            Texts{"9:26: simulation.time_step: the run would take 2e+15 steps or more, 10 million are allowed; take a "
                  "longer `time_step`"});
  EXPECT_EQ(
      timeline_errors("  - wait: { for: 1 s }\n"
                      "  - palpate: { tool: probe, body: organ, depth: 5 mm, speed: 1e-12 mm/s }\n"),
      Texts{"10:5: timeline[2].palpate: the run would take 2e+15 steps or more, 10 million are allowed; let the clip "
            "end sooner"});
  EXPECT_EQ(errors_of(checked_scenario("timeline: [ wait: { for: 9.9 s } ]\nsimulation: { time_step: 1 us }\n")),
            Texts{});
}

TEST(LintPass, AToolThatGoesAllItsDepthInOneStepIsToldOf) {
  const auto warnings_of = [](const std::string& clip, const std::string& step) {
    Diagnostics diagnostics;
    lint_pass(checked_scenario("timeline: [ " + clip + " ]\nsimulation: { time_step: " + step + " }\n"), diagnostics);
    return short_texts(diagnostics.warnings);
  };
  const std::string fast = "palpate: { tool: edge, depth: 6 mm, speed: 20 m/s }";
  EXPECT_EQ(
      warnings_of(fast, "10 ms"),
      Texts{"8:56: timeline[1].palpate.speed: the tool goes 200 mm in a `time_step` of 10 ms, farther than its "
            "`depth` of 6 mm: nothing of its way through the wall is seen; take a shorter step or a lower speed"});
  EXPECT_EQ(warnings_of(fast, "0.3 ms"), Texts{});
  EXPECT_EQ(
      warnings_of("incise: { tool: edge, path: [[0, 0, 0], [1 cm, 0, 0]], depth: 0.1 mm, speed: 20 mm/s }", "10 ms"),
      Texts{})
      << "a blade goes along its path";
}

TEST(LintPass, ALongStepOfADynamicAnalysisIsToldOf) {
  const auto warnings_of = [](const std::string& simulation) {
    Diagnostics diagnostics;
    lint_pass(checked_scenario("simulation: { " + simulation + " }\n"), diagnostics);
    return short_texts(diagnostics.warnings);
  };
  EXPECT_EQ(warnings_of("time_step: 500 ms"),
            Texts{"8:26: simulation.time_step: 500 ms is long for a dynamic analysis, which damps what is faster; take "
                  "5 ms or the like, or `analysis: quasi_static`"});
  EXPECT_EQ(warnings_of("time_step: 100 ms"), Texts{});
  EXPECT_EQ(warnings_of("analysis: quasi_static, time_step: 500 ms"), Texts{});
}

TEST(LintPass, GoldensLieWithinAKnownTimelineAndAtDifferentTimes) {
  EXPECT_EQ(errors_of(checked_scenario("timeline: [ wait: { for: 2 s } ]\n"
                                       "golden:\n"
                                       "  - { at: 2 s, max: 1, mean: 1, why: end }\n"
                                       "  - { at: 2 s, max: 1, mean: 1, why: again }\n"
                                       "  - { at: 2.1 s, max: 1, mean: 1, why: late }\n")),
            (Texts{"11:11: golden[2].at: there is a golden at this time already",
                   "12:11: golden[3].at: the timeline ends at 2 s"}));
}

TEST(LintPass, OneGoldenIsOfTheVideoWhereThereIsOne) {
  EXPECT_EQ(errors_of(checked_scenario("record: { video: false }\n"
                                       "golden:\n"
                                       "  - { video: 3, max: 1, mean: 1, why: all }\n"
                                       "  - { video: 5, max: 1, mean: 1, why: again }\n")),
            (Texts{"11:14: golden[2].video: there is a golden of the video already",
                   "10:14: golden[1].video: `record.video` says that there is none",
                   "11:14: golden[2].video: `record.video` says that there is none"}));
}

TEST(LintPass, WhatExcusesPixelsOfAGoldenNeedsTheFractionThatMayFail) {
  EXPECT_EQ(
      errors_of(checked_scenario("golden:\n"
                                 "  - { at: 0, max: 9, mean: 1, level: 2, why: some }\n"
                                 "  - { at: 1 s, max: 9, mean: 1, failing: 0.1, level: 2, shift: 1, why: some }\n")),
      Texts{"9:38: golden[1].level: is of no use without `failing`"});
}

TEST(LintPass, AFluidNeedsAShapeThatIsClosed) {
  for (const std::string shape : {"sheet", "disc", "annulus", "strip"}) {
    Diagnostics ignored;
    const std::string text =
        "thinwall: 1\nbodies: { a: { surface: { shape: " + shape +
        " }, wall: { thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 1 kPa } } } }\n";
    EXPECT_EQ(errors_of(unit_pass(parse_text(text, ignored), scenario_schema(), ignored)),
              Texts{"2:34: bodies.a.contents: the shape `" + shape +
                    "` is open and holds no fluid; write `contents: { fluid: none }`"});
  }
}

TEST(LintPass, ShapesAndBoxesAreNotTurnedInsideOut) {
  EXPECT_EQ(errors_of(checked_scenario("", "{ shape: annulus, radius: 5 mm, inner_radius: 5 mm }")),
            Texts{"5:60: bodies.organ.surface.inner_radius: the hole must be smaller than `radius`"});
  EXPECT_EQ(errors_of(checked_scenario("    fixed: [ region: { box: { min: [0, 0, 1 m], max: [1 m, 1 m, 0] } } ]\n")),
            Texts{"8:24: bodies.organ.fixed[1].region.box: a component of `min` is larger than that of `max`"});
}

TEST(LintPass, CamerasLookSomewhereAndToolsHaveAFrame) {
  EXPECT_EQ(errors_of(checked_scenario("camera: { position: [0, 0, 1 m], target: [0, 0, 1 m] }\n")),
            Texts{"8:42: camera.target: the camera stands where it looks"});
  EXPECT_EQ(errors_of(checked_scenario("camera: { position: [0, 0, 1 m], target: [0, 0, 0], up: [0, 0, 1] }\n")),
            Texts{"8:57: camera.up: the camera looks along `up`"});
  EXPECT_EQ(timeline_errors("  - palpate: { tool: edge, depth: 1 mm, axis: [0, 0, 3] }\n"),
            Texts{"9:47: timeline[1].palpate.axis: the axis lies along the direction"});
  EXPECT_EQ(timeline_errors("  - move: { tool: edge, from: [0, 0, 0], to: [1 m, 0, 0], axis: [1, 0, 0] }\n"),
            Texts{"9:65: timeline[1].move.axis: the axis lies along the direction"});
  EXPECT_EQ(timeline_errors("  - move: { tool: edge, from: [0, 0, 0], to: [0, 0, 0] }\n"),
            Texts{"9:5: timeline[1].move: `direction` is missing: `from` and `to` are the same point"});
  EXPECT_EQ(timeline_errors("  - move: { tool: edge, by: [0, 0, 0] }\n"),
            Texts{"9:5: timeline[1].move: `direction` is missing: `by` leads nowhere"});
  EXPECT_EQ(timeline_errors("  - move: { tool: edge, by: [1 m, 0, 0], axis: [1, 0, 0] }\n"),
            Texts{"9:48: timeline[1].move.axis: the axis lies along the direction"});
  EXPECT_EQ(timeline_errors("  - move: { tool: edge, to: [1 m, 0, 0], by: [1 m, 0, 0] }\n"),
            Texts{"9:29: timeline[1].move.to: `by` and `to` exclude each other"});
  EXPECT_EQ(timeline_errors("  - palpate: { tool: edge, depth: 1 mm }\n"
                            "  - move: { tool: edge, from: [0, 0, 0], to: [0, 0, 0], axis: [1, 0, 0] }\n"
                            "  - move: { tool: edge, from: [0, 0, 0], to: [1 m, 0, 0], axis: [1, 0, 0] }\n"),
            Texts{})
      << "it keeps the direction that it has";
}

TEST(LintPass, CutsNeedTheirToolAndAToughWall) {
  const auto cut_errors = [](const std::string& clip, const std::string& toughness) {
    const std::string text =
        "thinwall: 1\n"
        "tools: { pin: { kind: needle, length: 30 mm }, blade: { kind: scalpel }, probe: { kind: point } }\n"
        "bodies: { organ: { surface: { shape: sphere }, wall: { thickness: 1 mm, " +
        toughness +
        "material: { law: neo_hookean, shear_modulus: 1 kPa } } } }\n"
        "timeline:\n  - " +
        clip + "\n";
    Diagnostics ignored;
    return errors_of(unit_pass(parse_text(text, ignored), scenario_schema(), ignored));
  };
  const std::string tough = "toughness: 0.4 kJ/m^2, ", path = "path: [[0, 0, 20 mm], [5 mm, 0, 19 mm]]";
  EXPECT_EQ(cut_errors("pierce: { tool: pin, body: organ, depth: 30 mm }", tough), Texts{});
  EXPECT_EQ(cut_errors("incise: { tool: blade, body: organ, depth: 3 mm, " + path + " }", tough), Texts{});
  EXPECT_EQ(cut_errors("pierce: { tool: pin, body: organ, depth: 30.1 mm }", tough).size(), 1U);
  EXPECT_EQ(cut_errors("pierce: { tool: probe, body: organ, depth: 3 mm }", tough).size(), 1U);
  EXPECT_EQ(cut_errors("pierce: { tool: pin, body: organ, depth: 3 mm }", "").size(), 1U);
  EXPECT_EQ(cut_errors("palpate: { tool: pin, body: organ, depth: 3 mm }", ""), Texts{});
}

TEST(LintPass, ABladeThatIsMovedAndNeverCutsIsTold) {
  const auto warnings_of = [](const std::string& clips) {
    const std::string text =
        "thinwall: 1\ntools: { pin: { kind: needle }, blade: { kind: scalpel }, probe: { kind: point } }\ntimeline:\n" +
        clips;
    Diagnostics ignored, diagnostics;
    lint_pass(unit_pass(parse_text(text, ignored), scenario_schema(), ignored), diagnostics);
    return short_texts(diagnostics.warnings);
  };
  const std::string move_blade = "  - move: { tool: blade, to: [0, 0, 0] }\n";
  EXPECT_EQ(warnings_of(move_blade + move_blade + "  - move: { tool: probe, to: [0, 0, 0] }\n"),
            Texts{"4:5: timeline[1].move: `blade` is a scalpel and no clip lets it incise: walls that it is moved into "
                  "give way and stay whole"});
  EXPECT_EQ(warnings_of("  - move: { tool: pin, to: [0, 0, 0] }\n").size(), 1U);
  EXPECT_EQ(warnings_of(move_blade +
                        "  - incise: { tool: blade, body: organ, depth: 3 mm, path: [[0, 0, 0], [1 mm, 0, 0]] }\n"),
            Texts{});
}

TEST(LintPass, ADischargeOfContentsThatDoNotLeakIsTold) {
  const auto warnings_of = [](const std::string& contents) {
    const std::string text = "thinwall: 1\nbodies: { organ: { surface: { shape: sphere }, contents: " + contents +
                             ", wall: { thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 1 kPa } } } }\n";
    Diagnostics ignored, diagnostics;
    lint_pass(unit_pass(parse_text(text, ignored), scenario_schema(), ignored), diagnostics);
    return short_texts(diagnostics.warnings);
  };
  EXPECT_EQ(warnings_of("{ leaks: false, discharge: 0.6 }"),
            Texts{"2:85: bodies.organ.contents.discharge: has no effect on contents that do not leak"});
  EXPECT_EQ(warnings_of("{ leaks: false }"), Texts{});
  EXPECT_EQ(warnings_of("{ discharge: 0.6 }"), Texts{});
}

TEST(LintPass, WarnsOfColoursWithoutBothEndsWhichOnlyATakeGives) {
  const auto warnings_of = [](const std::string& ends) {
    Diagnostics diagnostics;
    lint_pass(checked_scenario("look: { data: { shows: von_mises_stress" + ends + " } }\n"), diagnostics);
    return short_texts(diagnostics.warnings);
  };
  const std::string cure =
      "8:15: look.data: `run` and `still` draw no picture without both ends of the colours: give `from` and `to`, or "
      "record with `run --no-render` and draw with `render`, which takes them from the whole take";
  EXPECT_EQ(warnings_of(""), Texts{cure});
  EXPECT_EQ(warnings_of(", from: 0 Pa"), Texts{cure});
  EXPECT_EQ(warnings_of(", from: 0 Pa, to: 20 kPa"), Texts{});
}

TEST(LintPass, WarnsOfMarksThatADataViewDoesNotShow) {
  const auto warnings_of = [](const std::string& look) {
    Diagnostics diagnostics;
    lint_pass(checked_scenario("teaching: { highlights: [ { body: organ, at: [0, 0, 0] } ] }\n" + look), diagnostics);
    return short_texts(diagnostics.warnings);
  };
  EXPECT_EQ(
      warnings_of("look: { data: { shows: strain, from: 0, to: 1 } }\n"),
      Texts{"8:25: teaching.highlights: are not drawn with `look.data`, where the wall's colours are its numbers; "
            "labels and arrows are"});
  EXPECT_EQ(warnings_of(""), Texts{});
}

TEST(LintPass, NoOtherLampShinesBesideAnEndoscopes) {
  const std::string cure =
      "does not shine beside the lamp of an endoscope; leave it out, or set `lights.endoscope` to 0";
  EXPECT_EQ(errors_of(checked_scenario("camera: { kind: endoscope }\nlights: { key: 2 }\n")),
            Texts{"9:16: lights.key: " + cure});
  EXPECT_EQ(errors_of(checked_scenario("lights: { endoscope: 1, fill: 0 }\n")), Texts{"8:31: lights.fill: " + cure});
  EXPECT_EQ(errors_of(checked_scenario("camera: { kind: endoscope }\nlights: { endoscope: 0, key: 2 }\n")), Texts{});
  EXPECT_EQ(errors_of(checked_scenario("camera: { kind: endoscope }\nlights: { environment: 2 }\n")), Texts{});
}

}  // namespace
}  // namespace thinwall
