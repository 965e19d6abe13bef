#include "studio/golden/ScenarioDifference.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

TEST(ScenarioDifference, EqualScenariosHaveNone) {
  EXPECT_TRUE(compare_scenarios(R"({"a": {"b": [1, 2]}})", R"({"a": {"b": [1, 2]}})").empty());
}

TEST(ScenarioDifference, NamesKeyAndBothValuesAndTheStage) {
  const auto changes = compare_scenarios(
      R"({"bodies": {"organ": {"wall": {"thickness": 0.001}}}, "lights": {"key": 1}, "timeline": [{"caption": "a"}]})",
      R"({"bodies": {"organ": {"wall": {"thickness": 0.002}}}, "lights": {"key": 2}, "timeline": [{"caption": "b"}]})");
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_EQ(to_text(changes[0]), "bodies.organ.wall.thickness 2 mm instead of 1 mm");
  EXPECT_EQ(changes[0].stage, ScenarioStage::kPhysics);
  EXPECT_EQ(changes[1].stage, ScenarioStage::kLook);
  EXPECT_EQ(changes[2].key, "timeline[1].caption");
  EXPECT_EQ(changes[2].stage, ScenarioStage::kOverlay);
}

TEST(ScenarioDifference, WhatATakeIsComparedWithMayBeOfPhysicsOrLook) {
  const auto changes = compare_scenarios(R"({"comparison": {"set": {"thickness": "4 mm"}, "captions": ["a", "b"]}})",
                                         R"({"comparison": {"set": {"thickness": "5 mm"}, "captions": ["a", "c"]}})");
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].stage, ScenarioStage::kOverlay);
  EXPECT_EQ(to_text(changes[1]), "comparison.set.thickness \"5 mm\" instead of \"4 mm\"");
  EXPECT_EQ(changes[1].stage, ScenarioStage::kSecondTake);
  EXPECT_EQ(list_changes(changes, {ScenarioStage::kPhysics}), to_text(changes[1]));
  EXPECT_EQ(list_changes(changes, {ScenarioStage::kLook}), to_text(changes[1]));
  EXPECT_EQ(list_changes(changes, {ScenarioStage::kOverlay}), to_text(changes[0]));
}

TEST(ScenarioDifference, KeysComeAndGo) {
  const auto changes = compare_scenarios(R"({"lights": {"of_old": 1}})", R"({"lights": {"of_late": 2}})");
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(to_text(changes[0]), "lights.of_late 2, which was not there");
  EXPECT_EQ(to_text(changes[1]), "lights.of_old is gone, it was 1");
}

TEST(ScenarioDifference, AKeyThatTheFormatDidNotHaveYetIsNoChangeWhileItHasItsDefault) {
  const std::string before = R"({"camera": {"kind": "pinhole"}, "timeline": [{"palpate": {"depth": 0.004}}]})";
  const std::string same = R"({"camera": {"kind": "pinhole", "aperture": 0.0, "noise": 0},
                               "timeline": [{"palpate": {"depth": 0.004, "standoff": 0.005}}]})";
  EXPECT_TRUE(compare_scenarios(before, same).empty());
  EXPECT_TRUE(compare_scenarios(same, before).empty());
  const auto changes = compare_scenarios(before, R"({"camera": {"kind": "pinhole", "aperture": 0.001},
                                                     "timeline": [{"palpate": {"depth": 0.004, "axis": [1, 0, 0]}}]})");
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(to_text(changes[0]), "camera.aperture 1 mm instead of 0 mm");
  EXPECT_EQ(to_text(changes[1]), "timeline[1].palpate.axis [1, 0, 0], which was not there") << "it has no default";
  EXPECT_EQ(changes[1].stage, ScenarioStage::kPhysics);
}

TEST(ScenarioDifference, AClipThatHasComeAtTheEndIsNamedAlone) {
  const std::string before = R"({"timeline": [{"wait": {"for": 1}}]})";
  const std::string after = R"({"timeline": [{"wait": {"for": 1}}, {"wait": {"for": 0.1}}]})";
  const auto come = compare_scenarios(before, after);
  ASSERT_EQ(come.size(), 1U);
  EXPECT_EQ(to_text(come[0]), "timeline[2] {wait: {for: 0.1 s}}, which was not there");
  const auto gone = compare_scenarios(after, before);
  ASSERT_EQ(gone.size(), 1U);
  EXPECT_EQ(to_text(gone[0]), "timeline[2] is gone, it was {wait: {for: 0.1 s}}");
}

TEST(ScenarioDifference, AClipThatHasComeBetweenOthersIsOneChange) {
  EXPECT_EQ(compare_scenarios(R"({"timeline": [{"a": 1}]})", R"({"timeline": [{"b": 2}, {"a": 1}]})").size(), 1U);
}

TEST(ScenarioDifference, QuantitiesAreToldAsAScenarioHasThem) {
  const auto text = [](const std::string& before, const std::string& after) {
    const auto changes = compare_scenarios(before, after);
    return changes.size() == 1 ? to_text(changes[0]) : std::to_string(changes.size()) + " changes";
  };
  EXPECT_EQ(text(R"({"camera": {}})", R"({"camera": {"orbit_speed": 0.5235987755982988}})"),
            "camera.orbit_speed 30 deg/s instead of 0 deg/s");
  const std::string material = R"({"bodies": {"organ": {"wall": {"material": {"law": "neo_hookean", "shear_modulus": )";
  EXPECT_EQ(text(material + "20000.0}}}}}", material + "21000.0}}}}}"),
            "bodies.organ.wall.material.shear_modulus 21 kPa instead of 20 kPa");
  const std::string label = R"({"teaching": {"labels": [{"text": "a", "body": "organ", "at": [0.0, 0.0, )";
  EXPECT_EQ(text(label + "0.02]}]}}", label + "0.018]}]}}"),
            "teaching.labels[1].at [0 mm, 0 mm, 18 mm] instead of [0 mm, 0 mm, 20 mm]");
}

TEST(ScenarioDifference, WhatDiffersInLateDigitsAloneIsToldWithAllOfThem) {
  const auto changes = compare_scenarios(R"({"tools": {"probe": {"kind": "sphere", "radius": 0.004}}})",
                                         R"({"tools": {"probe": {"kind": "sphere", "radius": 0.004000000001}}})");
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(to_text(changes[0]), "tools.probe.radius 0.004000000001 instead of 0.004");
}

TEST(ScenarioDifference, OfTeachingEachPartIsOfTheStageThatShowsIt) {
  const auto stage = [](const std::string& key, const std::string& value) {
    const auto changes = compare_scenarios("{}", R"({"teaching": {")" + key + "\": " + value + "}}");
    return changes.size() == 1 ? changes[0].stage : ScenarioStage::kNone;
  };
  EXPECT_EQ(stage("labels", R"([{"text": "a"}])"), ScenarioStage::kOverlay);
  EXPECT_EQ(stage("highlights", R"([{"radius": 0.005}])"), ScenarioStage::kLook);
  EXPECT_EQ(stage("freezes", R"([{"at": 1.0}])"), ScenarioStage::kTiming);
  EXPECT_EQ(stage("slow_motion", R"([{"from": 1.0}])"), ScenarioStage::kTiming);
  EXPECT_EQ(stage("title_card", R"({"title": "a"})"), ScenarioStage::kTiming);
  EXPECT_EQ(stage("end_card", R"({"title": "a"})"), ScenarioStage::kTiming);
  const auto words = compare_scenarios(R"({"teaching": {"end_card": {"title": "a", "text": "b"}}})",
                                       R"({"teaching": {"end_card": {"title": "a", "text": "c"}}})");
  ASSERT_EQ(words.size(), 1U);
  EXPECT_EQ(words[0].stage, ScenarioStage::kOverlay) << "the card takes as long as it did";
}

TEST(ScenarioDifference, WhatIsNoScenarioTellsNothing) {
  EXPECT_TRUE(compare_scenarios("", "{}").empty());
}

}  // namespace
}  // namespace thinwall
