#include "studio/director/StepTally.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

TEST(StepTally, SaysNothingOfStepsThatWereSolvedAsTheyWereAsked) {
  StepTally tally;
  tally.note("organ", {.newton_iterations = 5, .refinements = 2}, 0.1);
  EXPECT_TRUE(tally.warnings(1).empty());
}

TEST(StepTally, CountsAStepOnceForAllBodiesAndNamesTheFirst) {
  StepTally tally;
  tally.note("organ", {}, 0.1);
  tally.note("organ", {.halvings = 3}, 0.2);
  tally.note("sheet", {.halvings = 1}, 0.2);
  tally.note("sheet", {.halvings = 1}, 0.3);
  EXPECT_EQ(tally.warnings(3),
            std::vector<std::string>{"2 of 3 steps had to be divided to be solved (first: body `organ`, 0.2 s)"});
}

TEST(StepTally, TellsOfDragsLooseResidualsUnstableHeldAndCrumpledWallsApart) {
  StepTally tally;
  tally.note("organ", {.slowed = true}, 0.1);
  tally.note("organ", {.slowed = true, .loose = true}, 0.2);
  tally.note("organ", {.unstable = true}, 0.2);
  tally.note("organ", {.held = true}, 0.2);
  tally.note("organ", {.crumpled = true}, 0.3);
  const std::vector<std::string> warnings = tally.warnings(4);
  ASSERT_EQ(warnings.size(), 5u);
  EXPECT_EQ(warnings[0].rfind("2 of 4 steps slowed what nothing holds", 0), 0u) << warnings[0];
  EXPECT_EQ(warnings[1].rfind("1 of 4 steps end with a residual above", 0), 0u) << warnings[1];
  EXPECT_EQ(warnings[2].rfind("1 of 4 steps end in an equilibrium that is not stable", 0), 0u) << warnings[2];
  EXPECT_EQ(warnings[3].rfind("1 of 4 steps hold a body against what", 0), 0u) << warnings[3];
  EXPECT_EQ(warnings[4].rfind("1 of 4 steps crumpled a wall", 0), 0u) << warnings[4];
}

TEST(StepTally, TellsOfManyLaboriousStepsAndNotOfAFew) {
  const auto warnings_of = [](int laborious, int easy) {
    StepTally tally;
    for (int k = 0; k < laborious + easy; ++k) {
      tally.note("sheet", {.newton_iterations = k < laborious ? 41 : 40}, 0.1 * (k + 1));
    }
    return tally.warnings(laborious + easy);
  };
  EXPECT_TRUE(warnings_of(19, 0).empty());
  EXPECT_TRUE(warnings_of(20, 181).empty());
  const std::vector<std::string> warnings = warnings_of(20, 180);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].rfind("20 of 200 steps took more than 40 iterations each", 0), 0u) << warnings[0];
}

}  // namespace
}  // namespace thinwall
