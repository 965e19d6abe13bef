#include "studio/director/IntegratorEnergy.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

constexpr double kNone = 1e-12;  // joule

TEST(IntegratorEnergy, SaysNothingOfRoundOff) {
  IntegratorEnergy energy;
  energy.note("organ", {}, kNone, 0);
  energy.note("organ", {.elastic = 1e-15, .numerical = 1e-14}, kNone, 0.1);
  EXPECT_TRUE(energy.warnings(Analysis::kDynamic, true).empty());
}

TEST(IntegratorEnergy, SaysNothingUpToATenthOfTheLargestOtherTerm) {
  IntegratorEnergy energy;
  energy.note("organ", {}, kNone, 0);
  energy.note("organ", {.elastic = 0.5, .numerical = 0.099, .tool_work = -1}, kNone, 0.1);
  EXPECT_TRUE(energy.warnings(Analysis::kDynamic, true).empty());
  // What was small when it came is large beside nothing that comes later either.
  energy.note("organ", {.elastic = 1e-6, .numerical = 0.099}, kNone, 0.2);
  EXPECT_TRUE(energy.warnings(Analysis::kDynamic, true).empty());
}

TEST(IntegratorEnergy, TellsTheStepInWhichItJumped) {
  IntegratorEnergy energy;
  energy.note("calm", {}, kNone, 0);
  energy.note("organ", {}, kNone, 0);
  energy.note("organ", {.numerical = 0.01, .tool_work = 1}, kNone, 0.1);
  energy.note("organ", {.numerical = -1.94, .tool_work = 1}, kNone, 0.2);
  energy.note("organ", {.numerical = -0.02, .tool_work = 1}, kNone, 0.3);
  const std::vector<std::string> warnings = energy.warnings(Analysis::kDynamic, true);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "body `organ`: `numerical_J`, what the integrator takes, comes to -1.94 J, 194 % of the largest other "
            "energy: results are in doubt; it jumped (-1.95 J) in the step to 0.2 s; move or turn the tool more slowly "
            "there, or take a shorter `time_step`");
}

TEST(IntegratorEnergy, BlamesNoToolWhereThereIsNone) {
  IntegratorEnergy energy;
  energy.note("organ", {}, kNone, 0);
  energy.note("organ", {.elastic = 1, .numerical = 0.5}, kNone, 0.1);
  const std::string told = energy.warnings(Analysis::kDynamic, false).at(0);
  EXPECT_TRUE(told.ends_with("in the step to 0.1 s; take a shorter `time_step`")) << told;
}

TEST(IntegratorEnergy, KnowsThatAWallWhichSnapsThroughGivesOffEnergy) {
  IntegratorEnergy energy;
  energy.note("gives", {}, kNone, 0);
  energy.note("takes", {}, kNone, 0);
  energy.note("gives", {.elastic = 1, .numerical = 0.5}, kNone, 0.1);
  energy.note("takes", {.elastic = 1, .numerical = -0.5}, kNone, 0.1);
  const std::vector<std::string> told = energy.warnings(Analysis::kQuasiStatic, false);
  ASSERT_EQ(told.size(), 2u);
  EXPECT_TRUE(
      told[0].ends_with("0.1 s; where a wall snaps through there it gives that off, which is no error; else take a "
                        "shorter `time_step`"))
      << told[0];
  EXPECT_TRUE(told[1].ends_with("0.1 s; take a shorter `time_step`")) << told[1];
}

TEST(IntegratorEnergy, TellsOfWhatGrowsFromStepToStep) {
  IntegratorEnergy energy;
  energy.note("ball", {.kinetic = 1}, kNone, 0);
  for (int step = 1; step <= 10; ++step) {
    energy.note("ball", {.kinetic = 1 - 0.02 * step, .numerical = 0.02 * step}, kNone, 0.1 * step);
  }
  const std::vector<std::string> warnings = energy.warnings(Analysis::kDynamic, true);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("comes to 0.2 J, 20 %"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("it grew over many steps"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("`step_error`"), std::string::npos) << warnings[0];
}

TEST(IntegratorEnergy, MeasuresAgainstTheChangeOfGravityAndNotItsHeight) {
  IntegratorEnergy energy;
  energy.note("organ", {.gravity = 50}, kNone, 0);
  energy.note("organ", {.gravity = 49, .numerical = 0.5}, kNone, 0.1);
  ASSERT_EQ(energy.warnings(Analysis::kDynamic, true).size(), 1u);
  EXPECT_NE(energy.warnings(Analysis::kDynamic, true)[0].find("50 %"), std::string::npos)
      << energy.warnings(Analysis::kDynamic, true)[0];
}

}  // namespace
}  // namespace thinwall
