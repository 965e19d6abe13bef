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
  EXPECT_EQ(to_text(changes[0]), "bodies.organ.wall.thickness 0.002 instead of 0.001");
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
  EXPECT_EQ(list_changes(changes, ScenarioStage::kPhysics), to_text(changes[1]));
  EXPECT_EQ(list_changes(changes, ScenarioStage::kLook), to_text(changes[1]));
  EXPECT_EQ(list_changes(changes, ScenarioStage::kOverlay), to_text(changes[0]));
}

TEST(ScenarioDifference, KeysComeAndGo) {
  const auto changes = compare_scenarios(R"({"tools": {"a": {"radius": 1}}})", R"({"tools": {"a": {"length": 2}}})");
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(to_text(changes[0]), "tools.a.radius is gone, it was 1");
  EXPECT_EQ(to_text(changes[1]), "tools.a.length 2, which was not there");
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
  EXPECT_EQ(to_text(changes[0]), "camera.aperture 0.001 instead of 0.0");
  EXPECT_EQ(to_text(changes[1]), "timeline[1].palpate.axis [1,0,0], which was not there") << "it has no default";
  EXPECT_EQ(changes[1].stage, ScenarioStage::kPhysics);
}

TEST(ScenarioDifference, AnotherNumberOfClipsIsOneChange) {
  EXPECT_EQ(compare_scenarios(R"({"timeline": [{"a": 1}]})", R"({"timeline": [{"a": 1}, {"b": 2}]})").size(), 1U);
}

TEST(ScenarioDifference, WhatIsNoScenarioTellsNothing) {
  EXPECT_TRUE(compare_scenarios("", "{}").empty());
}

}  // namespace
}  // namespace thinwall
