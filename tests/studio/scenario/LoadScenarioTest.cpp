#include "studio/scenario/LoadScenario.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(THINWALL_SOURCE_DIR) / "tests/studio/scenario";

TEST(LoadScenario, ReadsTheExampleOfTheFormat) {
  const Scenario scenario = load_scenario(kFolder / "valid/contract.yaml", {{"depth", "3 mm"}});
  EXPECT_EQ(scenario.name, "contract");
  EXPECT_EQ(scenario.title, "Palpation of a fluid-filled hemisphere");
  ASSERT_EQ(scenario.bodies.size(), 1U);
  EXPECT_EQ(scenario.bodies[0].thickness.standard, 0.001);
  ASSERT_EQ(scenario.timeline.size(), 3U);
  EXPECT_EQ(std::get<PalpateClip>(scenario.timeline[0].action).depth, 0.003);
}

}  // namespace
}  // namespace thinwall
