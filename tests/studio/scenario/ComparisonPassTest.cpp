#include "studio/scenario/ComparisonPass.hpp"

#include <gtest/gtest.h>

#include "studio/scenario/LoadScenario.hpp"
#include "tests/studio/TemporaryFolder.hpp"
#include "tests/studio/scenario/ScenarioTestTools.hpp"

namespace thinwall {
namespace {

const std::string kStart = R"(thinwall: 1
parameters: { thickness: 2 mm, depth: 6 mm }
bodies:
  organ:
    surface: { shape: hemisphere, radius: 25 mm, triangles: 64 }
    wall: { thickness: "${thickness}", material: { law: neo_hookean, shear_modulus: 20 kPa } }
    fixed: [ { region: { group: base } } ]
tools: { probe: { kind: point } }
timeline:
  - palpate: { tool: probe, body: organ, at: [0, 0, 25 mm], direction: [0, 0, -1], depth: "${depth}", speed: 10 mm/s }
)";

class ComparisonPassTest : public testing::Test {
 protected:
  Scenario load(const std::string& rest, const Overrides& overrides = {}) {
    const std::filesystem::path file = folder_ / "test.yaml";
    std::ofstream(file) << kStart << rest;
    return load_scenario(file, overrides);
  }
  /// What is said of a scenario that is wrong.
  std::string complaint(const std::string& rest) {
    try {
      load(rest);
    } catch (const InputErrors& errors) {
      return errors.what();
    }
    return "";
  }
  static double thickness(const Scenario& scenario) { return scenario.bodies[0].thickness.standard; }

  TemporaryFolder folder_;
};

TEST_F(ComparisonPassTest, TheSecondTakeHasAnotherParameterAndEachCaptionItsOwnTakesValue) {
  const Scenario scenario =
      load("comparison: { set: { thickness: 4 mm }, captions: [\"${thickness} thick\", \"${thickness} thick\"] }\n");
  ASSERT_TRUE(scenario.comparison);
  EXPECT_DOUBLE_EQ(thickness(scenario), 0.002);
  EXPECT_DOUBLE_EQ(thickness(*scenario.comparison->second), 0.004);
  EXPECT_EQ(scenario.comparison->captions, (std::array<std::string, 2>{"2 mm thick", "4 mm thick"}));
  ASSERT_TRUE(scenario.view.comparison);
  EXPECT_EQ(scenario.view.comparison->captions, scenario.comparison->captions);
  EXPECT_FALSE(scenario.comparison->second->comparison);
}

TEST_F(ComparisonPassTest, APathChangesAValueInMappingsAndLists) {
  const Scenario scenario = load(
      "comparison:\n  set: { bodies.organ.wall.thickness: 3 mm, \"timeline[1].palpate.depth\": 4 mm, "
      "bodies.organ.contents: { fluid: incompressible, pressure: 500 Pa } }\n  captions: [a, b]\n");
  const Scenario& second = *scenario.comparison->second;
  EXPECT_DOUBLE_EQ(thickness(second), 0.003);
  EXPECT_DOUBLE_EQ(std::get<PalpateClip>(scenario.timeline[0].action).depth, 0.006);
  EXPECT_DOUBLE_EQ(std::get<PalpateClip>(second.timeline[0].action).depth, 0.004);
}

TEST_F(ComparisonPassTest, AnOverrideHoldsForBothTakesButNotOverWhatTheComparisonSets) {
  const std::string comparison = "comparison: { set: { thickness: 4 mm }, captions: [a, b] }\n";
  const Scenario scenario = load(comparison, {{"thickness", "1 mm"}, {"depth", "5 mm"}});
  EXPECT_DOUBLE_EQ(thickness(scenario), 0.001);
  EXPECT_DOUBLE_EQ(thickness(*scenario.comparison->second), 0.004);
  EXPECT_DOUBLE_EQ(std::get<PalpateClip>(scenario.comparison->second->timeline[0].action).depth, 0.005);
}

TEST_F(ComparisonPassTest, WhatIsUnusualInTheSecondTakeAloneIsToldOfToo) {
  const auto unusual = [&](const std::string& value) {
    const Scenario scenario = load("comparison: { set: { thickness: " + value + " }, captions: [a, b] }\n");
    return std::ranges::count_if(scenario.warnings,
                                 [](const std::string& text) { return text.find("is unusual") != std::string::npos; });
  };
  EXPECT_EQ(unusual("3 m"), 1);
  EXPECT_EQ(unusual("3 mm"), 0);
}

TEST_F(ComparisonPassTest, WhatBothTakesHaveInCommonCannotBeSet) {
  for (const std::string path :
       {"record.size: [320, 180]", "record.fps: 60", "comparison.captions: [c, d]", "look.overlays.gauge: false"}) {
    EXPECT_NE(complaint("record: { fps: 25 }\nlook: { overlays: {} }\ncomparison: { set: { " + path +
                        " }, captions: [a, b] }\n")
                  .find("both takes have this in common"),
              std::string::npos)
        << path;
  }
  EXPECT_EQ(complaint("look: {}\ncomparison: { set: { look.mesh: true }, captions: [a, b] }\n"), "")
      << "each half has a look of its own";
}

TEST_F(ComparisonPassTest, TakesThatAreAlikeAreToldOf) {
  const auto warnings = [&](const std::string& value) {
    std::string all;
    const Scenario scenario = load("comparison: { set: { thickness: " + value + " }, captions: [a, b] }\n");
    for (const std::string& warning : scenario.warnings) all += warning;
    return all;
  };
  EXPECT_NE(warnings("2 mm").find("both takes are alike"), std::string::npos);
  EXPECT_EQ(warnings("3 mm").find("both takes are alike"), std::string::npos);
}

TEST_F(ComparisonPassTest, MistakesAreToldWithTheirPlaceAndACure) {
  EXPECT_NE(complaint("comparison: { set: { thicknes: 4 mm }, captions: [a, b] }\n").find("did you mean `thickness`"),
            std::string::npos);
  EXPECT_NE(complaint("comparison: { set: { bodies.orgn.wall.thickness: 4 mm }, captions: [a, b] }\n")
                .find("did you mean `organ`"),
            std::string::npos);
  EXPECT_NE(complaint("comparison: { set: { \"timeline[2].palpate.depth\": 4 mm }, captions: [a, b] }\n")
                .find("`timeline` has 1 item, which are counted from 1, and no item 2"),
            std::string::npos);
  EXPECT_NE(complaint("comparison: { set: { \"timeline[0].palpate.depth\": 4 mm }, captions: [a, b] }\n")
                .find("and no item 0"),
            std::string::npos);
  EXPECT_NE(complaint("comparison: { set: { thickness: 4 s }, captions: [a, b] }\n").find("a length"),
            std::string::npos);
  EXPECT_NE(complaint("comparison: { set: {}, captions: [a, b] }\n").find("as `thickness: 3 mm`"), std::string::npos);
  EXPECT_NE(complaint("comparison: { set: 4 mm, captions: [a, b] }\n").find("as `thickness: 3 mm`"), std::string::npos);
  EXPECT_NE(complaint("comparison: { set: { thickness: 4 mm }, captions: [a] }\n").find("captions"), std::string::npos);
  const std::string twice = complaint(
      "cameras: { close: {} }\ncuts: [ { at: 1 s, beside: close } ]\n"
      "comparison: { set: { thickness: 4 mm }, captions: [a, b] }\n");
  EXPECT_NE(twice.find("cuts[1].beside"), std::string::npos) << twice;
}

}  // namespace
}  // namespace thinwall
