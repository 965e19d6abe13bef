#include "studio/scenario/TeachingReferences.hpp"

#include <gtest/gtest.h>

#include "studio/scenario/LoadScenario.hpp"
#include "tests/studio/scenario/CheckedText.hpp"

namespace thinwall {
namespace {

TEST(TeachingReferences, ALeftOutBodyIsTheOnlyOne) {
  CheckedValue root = checked_scenario("teaching: { labels: [ { text: Crown, at: [0, 0, 2 cm] } ] }\n");
  Diagnostics diagnostics;
  teaching_references(root, diagnostics);
  EXPECT_TRUE(diagnostics.errors.empty());
  EXPECT_EQ(root.at("teaching").at("labels").items[0].at("body").text, "organ");
}

TEST(TeachingReferences, AScenarioKeepsItsTeachingLayer) {
  const Scenario scenario = load_scenario(scenario_test_folder() / "valid/everything.yaml", {});
  const Teaching& teaching = scenario.teaching;
  ASSERT_EQ(teaching.annotations.labels.size(), 1U);
  const LabelDefinition& label = teaching.annotations.labels[0];
  EXPECT_EQ(label.text, "Crown");
  EXPECT_EQ(label.body, "bladder");
  EXPECT_EQ(label.at, (Double3{0, 0, 0.02}));
  EXPECT_EQ(label.side, LabelSide::kLeft);
  EXPECT_TRUE(label.span.holds(1.5));
  EXPECT_FALSE(label.span.holds(2.5));
  ASSERT_EQ(teaching.annotations.arrows.size(), 1U);
  EXPECT_EQ(teaching.annotations.arrows[0].length, 0.01);
  ASSERT_EQ(teaching.annotations.force_arrows.size(), 1U);
  EXPECT_EQ(teaching.annotations.force_arrows[0].full, 0.5);
  ASSERT_EQ(scenario.view.highlights.size(), 1U);
  EXPECT_EQ(scenario.view.highlights[0].radius, 0.004);
  EXPECT_EQ(scenario.view.highlights[0].end, 2);
  EXPECT_EQ(teaching.title_card->text, "Slowly");
  EXPECT_EQ(teaching.end_card->duration, 1);
  EXPECT_EQ(teaching.freezes.at(0).duration, 0.5);
  EXPECT_EQ(teaching.slow_motions.at(0).speed, 0.5);
}

}  // namespace
}  // namespace thinwall
