#include "studio/golden/Attribution.hpp"

#include <gtest/gtest.h>

#include "renderer/image/ImageHash.hpp"
#include "studio/golden/OverlayRecord.hpp"
#include "tests/studio/golden/GoldenScene.hpp"

namespace thinwall {
namespace {

class AttributionTest : public ::testing::Test {
 protected:
  void SetUp() override { scene_.approve(); }
  Attribution attribution_of(const JudgedScenario& judged) {
    EXPECT_EQ(judged.results[0].outcome, GoldenOutcome::kFailed) << judged.results[0].message;
    return judged.attributions[0].value_or(Attribution{});
  }
  void expect_words(const Attribution& attribution, const std::string& words) {
    EXPECT_NE(attribution.sentence.find(words), std::string::npos) << attribution.sentence;
  }

  GoldenScene scene_;
};

TEST_F(AttributionTest, WhatHasNotChangedHasNoCause) {
  const JudgedScenario judged = scene_.judge(golden_scene());
  EXPECT_EQ(judged.results[0].outcome, GoldenOutcome::kOk);
  EXPECT_FALSE(judged.attributions[0]);
}

TEST_F(AttributionTest, AChangedEngineIsToldWithStepQuantityAndAmount) {
  const Attribution attribution = attribution_of(scene_.judge(golden_scene(), synthetic_source({.depth = 0.005})));
  EXPECT_EQ(attribution.stage, ChangedStage::kPhysics);
  EXPECT_EQ(attribution.history.step, 1U);
  expect_words(attribution, "physics changed from step 1 on");
  expect_words(attribution, "(+25 %)");
  expect_words(attribution, "the scenario asks for the same, so the engine has changed");
  expect_words(attribution, "the renderer draws the golden's state as before");
}

TEST_F(AttributionTest, AStateOfAnApprovalThatWasKilledIsToldAndTheRendererIsNotBlamed) {
  // The state is the first that is written, the approval the last.
  const GoldenScene newer;
  newer.approve(golden_scene(), synthetic_source({.depth = 0.005}));
  const GoldenApproval approval = read_approvals(scene_.folder())[0];
  for (const std::string& file : {approval.state, approval.history}) {
    std::filesystem::copy_file(newer.folder() / file, scene_.folder() / file,
                               std::filesystem::copy_options::overwrite_existing);
  }
  const Attribution attribution = attribution_of(scene_.judge(golden_scene(), synthetic_source({.depth = 0.005})));
  EXPECT_EQ(attribution.stage, ChangedStage::kUnknown);
  expect_words(attribution, "is not the state that was approved; restore it from version control");
  EXPECT_EQ(scene_.judge(golden_scene()).results[0].outcome, GoldenOutcome::kGoldenMissing);
}

TEST_F(AttributionTest, AToolThatIsOutOfThePictureIsNoneOfTheGoldensStateEither) {
  const SyntheticRunOptions before{.waits = true}, deeper{.depth = 0.005, .waits = true};
  scene_.approve(golden_scene(), synthetic_source(before));
  expect_words(attribution_of(scene_.judge(golden_scene(), synthetic_source(deeper))),
               "the renderer draws the golden's state as before");
  // Approvals of earlier versions do not tell of it.
  std::vector<GoldenApproval> approvals = read_approvals(scene_.folder());
  EXPECT_EQ(approvals[0].set_aside, (std::vector<std::string>{"needle"}));
  approvals[0].set_aside = std::nullopt;
  write_approvals(scene_.folder(), approvals);
  expect_words(attribution_of(scene_.judge(golden_scene(), synthetic_source(deeper))),
               "the renderer draws the golden's state as before");
  // One that says otherwise is believed.
  approvals[0].set_aside = std::vector<std::string>{};
  write_approvals(scene_.folder(), approvals);
  expect_words(attribution_of(scene_.judge(golden_scene(), synthetic_source(deeper))),
               "the golden's state is drawn differently too, by up to 8 levels");
}

class ComparedAttributionTest : public AttributionTest {
 protected:
  void SetUp() override { scene_.approve(compared_scene(), synthetic_pair({}, {.depth = 0.003})); }
  Attribution attribution_of_pair(SyntheticRunOptions first, SyntheticRunOptions second,
                                  const Scenario& scenario = compared_scene(), double gain = 1) {
    return attribution_of(scene_.judge(scenario, synthetic_pair(first, second), view_painters(gain)));
  }
};

TEST_F(ComparedAttributionTest, WhatHasNotChangedIsGood) {
  const JudgedScenario judged = scene_.judge(compared_scene(), synthetic_pair({}, {.depth = 0.003}));
  EXPECT_EQ(judged.results[0].outcome, GoldenOutcome::kOk) << judged.results[0].message;
  EXPECT_EQ(judged.results[0].state.verdict, StateVerdict::kEqual) << judged.results[0].state.explanation;
}

TEST_F(ComparedAttributionTest, AnEngineThatChangesTheSecondTakeAloneIsPhysics) {
  const Attribution attribution = attribution_of_pair({}, {.depth = 0.0036});
  EXPECT_EQ(attribution.stage, ChangedStage::kPhysics);
  expect_words(attribution, "physics changed from step 1 on");
  expect_words(attribution, "of probe in the second take is");
  expect_words(attribution, "(+20 %); in the second take vertex");
  expect_words(attribution, "the scenario asks for the same, so the engine has changed");
  expect_words(attribution, "the renderer draws the golden's state as before");
  ASSERT_FALSE(attribution.layers.empty());
  EXPECT_EQ(attribution.layers[0].verdict.rfind("second take: largest difference", 0), 0U)
      << attribution.layers[0].verdict;
}

TEST_F(ComparedAttributionTest, BothTakesAreToldWhereBothHaveChanged) {
  const Attribution attribution = attribution_of_pair({.depth = 0.005}, {.depth = 0.0036});
  expect_words(attribution, "physics changed from step 1 on");
  expect_words(attribution, ", and in the second take vertex");
}

TEST_F(ComparedAttributionTest, AnotherParameterOfTheSecondTakeIsNamedAsTheCauseOfItsPhysics) {
  const Attribution attribution = attribution_of_pair({}, {.depth = 0.0036}, compared_scene("\"3.6 mm\""));
  EXPECT_EQ(attribution.stage, ChangedStage::kPhysics);
  expect_words(attribution, R"(the scenario has changed: comparison.set.depth "3.6 mm" instead of "3 mm")");
}

TEST_F(ComparedAttributionTest, AParameterThatLeavesBothStatesAsTheyWereIsOfTheLook) {
  const Attribution attribution = attribution_of_pair({}, {.depth = 0.003}, compared_scene("\"pale\""), 1.1);
  EXPECT_EQ(attribution.stage, ChangedStage::kLook);
  expect_words(attribution, R"(look changed, state identical: comparison.set.depth "pale" instead of "3 mm")");
}

TEST_F(ComparedAttributionTest, ACaptionOfAHalfIsNamedFromTheScenario) {
  Scenario scenario = compared_scene();
  scenario.resolved.replace(scenario.resolved.find("shallow"), 7, "shalow");
  scenario.view.comparison = std::make_shared<const TakeComparison>(TakeComparison{{"deep", "shalow"}, {}});
  const Attribution attribution = attribution_of_pair({}, {.depth = 0.003}, scenario);
  EXPECT_EQ(attribution.stage, ChangedStage::kOverlay);
  EXPECT_EQ(
      attribution.sentence,
      R"(overlay changed: comparison.captions ["deep", "shalow"] instead of ["deep", "shallow"]; the picture below is )"
      "identical");
}

TEST_F(ComparedAttributionTest, AChangedRendererIsToldWithBothStatesIdentical) {
  EXPECT_EQ(attribution_of_pair({}, {.depth = 0.003}, compared_scene(), 1.1).sentence,
            "renderer changed, state and look identical");
}

TEST_F(ComparedAttributionTest, AnApprovalOfOneTakeAloneLeavesItOpen) {
  std::vector<GoldenApproval> approvals = read_approvals(scene_.folder());
  approvals[0].second_state = approvals[0].history = "";
  write_approvals(scene_.folder(), approvals);
  const Attribution attribution = attribution_of_pair({}, {.depth = 0.0036});
  EXPECT_EQ(attribution.stage, ChangedStage::kUnknown);
  expect_words(attribution, "in the second take nothing is approved; approve anew");
}

TEST_F(AttributionTest, AChangedMaterialIsNamed) {
  const Attribution attribution =
      attribution_of(scene_.judge(golden_scene(1, "20400.0"), synthetic_source({.depth = 0.005})));
  EXPECT_EQ(attribution.stage, ChangedStage::kPhysics);
  expect_words(attribution, "bodies.organ.shear_modulus 20400.0 instead of 20000.0");
}

TEST_F(AttributionTest, AChangedRendererIsToldWithTheStateIdentical) {
  const Attribution attribution = attribution_of(scene_.judge(golden_scene(), synthetic_source(), view_painters(1.1)));
  EXPECT_EQ(attribution.stage, ChangedStage::kRenderer);
  EXPECT_EQ(attribution.sentence, "renderer changed, state and look identical");
}

TEST_F(AttributionTest, AChangedRendererBesideChangedPhysicsIsToldToo) {
  const Attribution attribution =
      attribution_of(scene_.judge(golden_scene(), synthetic_source({.depth = 0.005}), view_painters(1.1)));
  EXPECT_EQ(attribution.stage, ChangedStage::kPhysics);
  expect_words(attribution, "the golden's state is drawn differently too, by up to ");
}

TEST_F(AttributionTest, ARoundingOfTheDriverBesideChangedPhysicsIsNoChangedRenderer) {
  // No level of 255 moves by more than one.
  const Attribution attribution =
      attribution_of(scene_.judge(golden_scene(), synthetic_source({.depth = 0.005}), view_painters(1.004)));
  EXPECT_EQ(attribution.stage, ChangedStage::kPhysics);
  expect_words(attribution, "; the renderer draws the golden's state as before, to 1 level");
}

TEST_F(AttributionTest, AChangedLookBesideChangedPhysicsIsNamed) {
  const Attribution attribution =
      attribution_of(scene_.judge(golden_scene(1.1, "20400.0"), synthetic_source({.depth = 0.005})));
  EXPECT_EQ(attribution.stage, ChangedStage::kPhysics);
  expect_words(attribution, "bodies.organ.shear_modulus 20400.0 instead of 20000.0");
  expect_words(attribution, "the look has changed too: lights.key 1.1 instead of 1");
}

TEST_F(AttributionTest, ATextThatChangesWithTheLookIsNamedToo) {
  Scenario scenario = golden_scene(1.1);
  scenario.resolved.insert(1, R"("title": "Another sheet", )");
  const Attribution attribution = attribution_of(scene_.judge(scenario));
  EXPECT_EQ(attribution.stage, ChangedStage::kLook);
  expect_words(attribution, "lights.key 1.1 instead of 1");
  expect_words(attribution, "title");
}

TEST_F(AttributionTest, AFileThatTheScenarioNamesIsBlamedBeforeTheEngine) {
  Scenario scenario = golden_scene();
  scenario.resolved.insert(1, R"("surface": {"mesh": "organ.obj"}, )");
  scenario.file = scene_.temporary() / "scene.yaml";
  write_bytes(scene_.temporary() / "organ.obj", "v 0 0 0");
  scene_.approve(scenario);
  const SourceFactory deeper = synthetic_source({.depth = 0.005});
  expect_words(attribution_of(scene_.judge(scenario, deeper)), "so the engine has changed");
  write_bytes(scene_.temporary() / "organ.obj", "v 0 0 1");
  const Attribution attribution = attribution_of(scene_.judge(scenario, deeper));
  expect_words(attribution, "organ.obj, which the scenario names, has changed");
  EXPECT_EQ(attribution.sentence.find("so the engine has changed"), std::string::npos) << attribution.sentence;
  std::vector<GoldenApproval> approvals = read_approvals(scene_.folder());
  approvals[0].files.clear();
  write_approvals(scene_.folder(), approvals);
  expect_words(attribution_of(scene_.judge(scenario, deeper)), "so the engine has changed, or organ.obj");
}

TEST_F(AttributionTest, ADamagedGoldenLeavesTheOthersOfItsScenario) {
  Scenario scenario = golden_scene();
  scenario.goldens.push_back({.at = 0.05, .max = 8, .mean = 0.2, .why = "rounding"});
  const JudgedScenario before = scene_.judge(scenario);
  renew_golden(scenario, before.pictures.pictures[1], before.pictures.driver, scene_.folder(), "someone", "right");
  write_bytes(scene_.folder() / read_approvals(scene_.folder())[0].image, "no picture");
  const JudgedScenario judged = scene_.judge(scenario);
  ASSERT_EQ(judged.results.size(), 2U);
  EXPECT_EQ(judged.results[0].outcome, GoldenOutcome::kOk) << judged.results[0].message;
  EXPECT_EQ(judged.results[1].outcome, GoldenOutcome::kBroken);
}

TEST_F(AttributionTest, AnotherWayToTheSameStateIsPhysicsWhereOnlyTheOverlayShowsIt) {
  const GoldenApproval approval = read_approvals(scene_.folder())[0];
  GoldenPicture picture = scene_.judge(golden_scene(), synthetic_source({.depth = 0.005})).pictures.pictures[0];
  GoldenResult result;
  result.at = approval.at;
  result.driver = approval.driver;
  result.state = {.verdict = StateVerdict::kEqual, .explanation = "equal"};
  picture.scene_hash = approval.scene_hash;
  const auto stage = [&] { return attribute(golden_scene(), picture, result, scene_.folder(), view_painters()).stage; };
  EXPECT_EQ(stage(), ChangedStage::kPhysics);
  picture.scene_hash = "another";
  EXPECT_EQ(stage(), ChangedStage::kRenderer);
}

TEST_F(AttributionTest, AChangedLookIsNamedAndDrawnAsItWas) {
  const Attribution attribution = attribution_of(scene_.judge(golden_scene(1.2)));
  EXPECT_EQ(attribution.stage, ChangedStage::kLook);
  expect_words(attribution, "look changed, state identical: lights.key 1.2 instead of 1");
  ASSERT_TRUE(attribution.golden_look);
  EXPECT_EQ(image_hash(*attribution.golden_look), read_approvals(scene_.folder())[0].scene_hash);
}

TEST_F(AttributionTest, AChangedTextIsNamed) {
  Scenario scenario = golden_scene();
  scenario.title = "A sheat";
  const Attribution attribution = attribution_of(scene_.judge(scenario));
  EXPECT_EQ(attribution.stage, ChangedStage::kOverlay);
  EXPECT_EQ(attribution.sentence,
            "overlay changed: title \"A sheat\" instead of \"A sheet\"; the picture below is identical");
}

/// With one more value in what the scenario asks for.
Scenario with(const std::string& member, Scenario scenario = golden_scene()) {
  scenario.resolved.insert(1, member + ", ");
  return scenario;
}

TEST_F(AttributionTest, AMarkOnAWallIsOfTheLook) {
  const Scenario scenario = with(R"("teaching": {"highlights": [{"radius": 0.005}]})");
  const Attribution attribution = attribution_of(scene_.judge(scenario, synthetic_source(), view_painters(1.1)));
  EXPECT_EQ(attribution.stage, ChangedStage::kLook);
  EXPECT_EQ(attribution.sentence.rfind("look changed, state identical: teaching.highlights[1] {", 0), 0U)
      << attribution.sentence;
}

TEST_F(AttributionTest, ACaptionIsNamedByItsPlaceInTheScenario) {
  const std::string clip = R"("timeline": [{"wait": {"for": 1.0, "caption": )";
  scene_.approve(with(clip + "\"Presing\"}}]"));
  Scenario scenario = with(clip + "\"Pressing\"}}]");
  scenario.title = "A sheet that is pressed";  // what is written over the picture
  EXPECT_EQ(
      attribution_of(scene_.judge(scenario)).sentence,
      R"(overlay changed: timeline[1].wait.caption "Pressing" instead of "Presing"; the picture below is identical)");
}

TEST_F(AttributionTest, WhatTheScenarioAsksForOtherwiseIsToldBesideItsCaption) {
  const auto clip = [](const std::string& depth) {
    return R"("timeline": [{"palpate": {"depth": )" + depth + R"(, "caption": "Pressed )" + depth + R"( deep"}}])";
  };
  scene_.approve(with(clip("0.006")));
  Scenario scenario = with(clip("0.007"));
  scenario.title = "A sheet that is pressed deeper";  // what is written over the picture
  expect_words(attribution_of(scene_.judge(scenario)),
               "; the scenario has changed too: timeline[1].palpate.depth 7 mm instead of 6 mm; the picture below is");
}

TEST_F(AttributionTest, ATextThatFollowsFromTheTimelineIsToldWithIt) {
  Scenario scenario = with(R"("timeline": [{"wait": {"for": 0.1}}])");
  scenario.title = "Another sheet";
  EXPECT_EQ(attribution_of(scene_.judge(scenario)).sentence,
            "overlay changed: title \"Another sheet\" instead of \"A sheet\"; the scenario has changed: timeline[1] "
            "{wait: {for: 0.1 s}}, which was not there; the picture below is identical");
}

TEST_F(AttributionTest, AnOverlayWithoutOtherTextsIsToldByWhatTheScenarioAsksFor) {
  const Scenario scenario = with(R"("simulation": {"time_step": 0.01})");
  JudgedScenario judged = scene_.judge(scenario);
  judged.pictures.pictures[0].image.pixels[100] ^= 64;  // as a curve of more points
  const GoldenResult result = compare_with_golden("sheet", scenario.goldens[0], judged.pictures.pictures[0],
                                                  judged.pictures.driver, scene_.folder());
  const Attribution attribution =
      attribute(scenario, judged.pictures.pictures[0], result, scene_.folder(), view_painters());
  EXPECT_EQ(attribution.stage, ChangedStage::kOverlay);
  expect_words(attribution, "overlay changed; the scenario has changed: simulation.time_step 10 ms instead of ");
  expect_words(attribution, "; the picture below is identical");
}

TEST_F(AttributionTest, ARendererIsNotBlamedWhereTheScenarioAsksForAnotherTool) {
  const Scenario scenario = with(R"("tools": {"probe": {"kind": "sphere", "radius": 0.005}})");
  const Attribution attribution = attribution_of(scene_.judge(scenario, synthetic_source(), view_painters(1.1)));
  EXPECT_EQ(attribution.stage, ChangedStage::kLook);
  expect_words(attribution, "picture changed, state identical; the scenario has changed: tools.probe {friction: 0, ");
}

TEST_F(AttributionTest, WhenAVideoStandsStillExplainsNoPicture) {
  const Scenario scenario = with(R"("teaching": {"freezes": [{"at": 0.05}]})");
  EXPECT_EQ(attribution_of(scene_.judge(scenario, synthetic_source(), view_painters(1.1))).stage,
            ChangedStage::kRenderer);
}

TEST_F(AttributionTest, ASecondTakeThatHasComeIsOfTheLook) {
  const Attribution attribution =
      attribution_of(scene_.judge(compared_scene(), synthetic_pair({}, {.depth = 0.003}), view_painters(1.1)));
  EXPECT_EQ(attribution.stage, ChangedStage::kLook);
  expect_words(attribution, R"(look changed, state identical: comparison {captions: ["deep", "shallow"], set: {depth)");
}

TEST_F(AttributionTest, AnApprovalWithoutEvidenceStillTellsStateFromPicture) {
  std::vector<GoldenApproval> approvals = read_approvals(scene_.folder());
  approvals[0].history = approvals[0].scene_hash = approvals[0].overlay = "";
  write_approvals(scene_.folder(), approvals);
  EXPECT_EQ(attribution_of(scene_.judge(golden_scene(), synthetic_source(), view_painters(1.1))).stage,
            ChangedStage::kRenderer);
  EXPECT_EQ(attribution_of(scene_.judge(golden_scene(), synthetic_source({.depth = 0.006}))).stage,
            ChangedStage::kPhysics);
}

TEST_F(AttributionTest, WithoutTheGoldensStateTheEngineIsNotBlamed) {
  const std::filesystem::path state = scene_.folder() / read_approvals(scene_.folder())[0].state;
  std::filesystem::resize_file(state, 3000);
  const JudgedScenario judged = scene_.judge(golden_scene(), synthetic_source({.depth = 0.006}));
  const Attribution attribution = attribution_of(judged);
  EXPECT_EQ(attribution.stage, ChangedStage::kPhysics);
  expect_words(attribution, "; whether the scenario asks for the same is open, as the golden's cannot be read");
  EXPECT_EQ(attribution.sentence.find("the engine has changed"), std::string::npos) << attribution.sentence;
  const std::string& message = judged.results[0].message;
  EXPECT_NE(message.find("; restore it from version control, or approve the picture anew"), std::string::npos)
      << message;
  EXPECT_EQ(message.find("run the scenario again"), std::string::npos) << message;
}

TEST_F(AttributionTest, PhysicsThatChangesWithinTheLimitsIsMentioned) {
  const JudgedScenario judged = scene_.judge(golden_scene(), synthetic_source({.depth = 0.004002}));
  ASSERT_EQ(judged.results[0].outcome, GoldenOutcome::kOk) << judged.results[0].message;
  EXPECT_NE(judged.results[0].message.find("within the limits, though physics changed from step 2 on"),
            std::string::npos)
      << judged.results[0].message;
}

TEST_F(AttributionTest, ARendererThatChangesWithinTheLimitsIsMentioned) {
  Scenario scenario = golden_scene();
  scenario.goldens[0].mean = 1;
  const JudgedScenario judged = scene_.judge(scenario, synthetic_source(), view_painters(1.004));
  ASSERT_EQ(judged.results[0].outcome, GoldenOutcome::kOk) << judged.results[0].message;
  EXPECT_NE(judged.results[0].message.find("within the limits, though the same state is drawn differently"),
            std::string::npos)
      << judged.results[0].message;
}

TEST(OverlayRecord, NumbersCountFromWhatIsShownOfThem) {
  OverlayContent content{.title = "A", .caption = "", .phase = "", .tool = "", .force = 0.25, .history = {}};
  const std::string golden = overlay_record(content);
  content.force = 0.2500001;
  EXPECT_TRUE(compare_overlays(golden, overlay_record(content)).empty());
  content.force = 0.26;
  EXPECT_EQ(compare_overlays(golden, overlay_record(content)),
            std::vector<std::string>{"force 0.26 N instead of 0.25 N"});
  EXPECT_TRUE(compare_overlays("", golden).empty());
}

TEST(OverlayRecord, QuantitiesAreToldInTheUnitsOfAScenario) {
  OverlayContent content{.title = "A", .caption = "", .phase = "", .tool = "", .depth = 0.004, .history = {}};
  const std::string golden = overlay_record(content);
  content.depth = 0.00421987;
  EXPECT_EQ(compare_overlays(golden, overlay_record(content)),
            std::vector<std::string>{"depth 4.22 mm instead of 4 mm"});
}

TEST(StateLayersTest, TellsHowFarWhatPixelsShowHasMoved) {
  const Snapshot golden = SyntheticRun({.depth = 0.004}).moment(20).snapshot;
  const Snapshot today = SyntheticRun({.depth = 0.006}).moment(20).snapshot;
  Shot shot;
  shot.camera.position = {0, -0.06, 0.05};
  const std::vector<StateLayer> layers = state_layers(golden, today, shot, {.width = 96, .height = 64});
  ASSERT_EQ(layers.size(), 4U);
  const auto verdict = [&](const std::string& name) {
    for (const StateLayer& layer : layers) {
      if (layer.name == name) return layer.verdict;
    }
    return std::string();
  };
  for (const char* name : {"depth", "normals", "parts", "flow"}) EXPECT_NE(verdict(name), "") << name;
  // The middle of the sheet is dented by two millimetres more.
  EXPECT_EQ(verdict("depth").rfind("largest difference ", 0), 0U) << verdict("depth");
  EXPECT_EQ(verdict("flow").find("largest 0 pixels"), std::string::npos) << verdict("flow");
  const std::vector<StateLayer> same = state_layers(golden, golden, shot, {.width = 96, .height = 64});
  EXPECT_EQ(same[0].verdict, "equal");
  EXPECT_EQ(same[2].verdict.rfind("smallest overlap 1.0000", 0), 0U) << same[2].verdict;
  EXPECT_EQ(same[0].golden.pixels, same[0].today.pixels);
}

}  // namespace
}  // namespace thinwall
