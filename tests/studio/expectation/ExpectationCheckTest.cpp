#include "studio/expectation/ExpectationCheck.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "studio/schema/ExpectationQuantity.hpp"

namespace thinwall {
namespace {

/// Records at 0, 1, 2 and 4 s of a force along x of 0, 3, -1 and 1 N.
ExpectationCheck checked(const Expectation& expectation) {
  ExpectationCheck check({expectation});
  for (const auto& [time, force] : {std::pair{0.0, 0.0}, {1.0, 3.0}, {2.0, -1.0}, {4.0, 1.0}}) {
    StepRecord record{
        .time = time, .tools = {{.tool = "other", .phase = ""}, {.tool = "probe", .phase = ""}}, .bodies = {}};
    record.tools[0].force.x() = 100;
    record.tools[1].force.x() = force;
    check.add(record);
  }
  return check;
}

std::optional<double> value_of(Expectation expectation) {
  expectation.subject = "probe";
  return checked(expectation).results().at(0).value;
}

TEST(ExpectationCheck, AChamberHasItsOwnPressureAndVolumes) {
  const StepRecord record{.time = 0,
                          .tools = {},
                          .bodies = {{.body = "gland", .volume = 9e-6, .pressure = 100}},
                          .points = {},
                          .chambers = {{.body = "gland", .chamber = "left", .pressure = 100},
                                       {.body = "gland", .chamber = "right", .volume = 4e-6, .pressure = 300}}};
  const auto text_of = [&](const std::string& quantity, const std::string& chamber, double bound) {
    ExpectationCheck check({{.quantity = quantity, .subject = "gland", .chamber = chamber, .highest = bound}});
    check.add(record);
    return to_text(check.results()[0]);
  };
  EXPECT_EQ(text_of("final_pressure", "right", 400),
            "met: final_pressure of chamber `right` of body `gland` is 0.3 kPa, expected from 0 kPa to 0.4 kPa");
  EXPECT_EQ(text_of("final_volume", "right", 1e-6),
            "FAILED: final_volume of chamber `right` of body `gland` is 4 ml, expected from 0 ml to 1 ml");
  EXPECT_EQ(text_of("final_volume", "", 1e-5),
            "met: final_volume of body `gland` is 9 ml, expected from 0 ml to 10 ml");
}

TEST(ExpectationCheck, AMomentLiesOnTheLineBetweenSteps) {
  EXPECT_EQ(value_of({.quantity = "force_x", .at = 1}), 3);
  EXPECT_EQ(value_of({.quantity = "force_x", .at = 1.25}), 2);
  EXPECT_EQ(value_of({.quantity = "force_x", .at = 0}), 0);
  EXPECT_EQ(value_of({.quantity = "force_x", .at = 4}), 1);
  EXPECT_EQ(value_of({.quantity = "force_x", .at = 4.1}), std::nullopt) << "the run did not reach it";
}

TEST(ExpectationCheck, PeaksLowestValuesAndAveragesAreThoseOfTheSpan) {
  EXPECT_EQ(value_of({.quantity = "peak_force_x"}), 3);
  EXPECT_EQ(value_of({.quantity = "lowest_force_x"}), -1);
  EXPECT_EQ(value_of({.quantity = "peak_force_x", .from = 1.5}), 1);
  EXPECT_EQ(value_of({.quantity = "peak_force_x", .from = 1.25, .until = 1.75}), 2);
  EXPECT_EQ(value_of({.quantity = "final_force_x"}), 1);
  // Trapezoids: 1.5 + 1 + 0 newton seconds in 4 s, and 2.5 in the first two seconds.
  EXPECT_EQ(value_of({.quantity = "mean_force_x"}), 2.5 / 4);
  EXPECT_EQ(value_of({.quantity = "mean_force_x", .until = 2}), 2.5 / 2);
  EXPECT_EQ(value_of({.quantity = "mean_force_x", .from = 1, .until = 1}), 3);
  EXPECT_EQ(value_of({.quantity = "peak_force"}), 3) << "of `force` the magnitude";
}

TEST(ExpectationCheck, PassesAtItsBoundsAndFailsBeyondThem) {
  Expectation expectation{.quantity = "peak_force", .subject = "probe", .lowest = 3, .highest = 3};
  EXPECT_TRUE(checked(expectation).results()[0].passed);
  expectation = {.quantity = "peak_force", .subject = "probe", .lowest = 1, .highest = 2.99};
  EXPECT_FALSE(checked(expectation).results()[0].passed);
  EXPECT_EQ(to_text(checked(expectation).results()[0]),
            "FAILED: peak_force of tool `probe` is 3 N, expected from 1 N to 2.99 N");
  EXPECT_EQ(to_text({.expectation = {.quantity = "final_volume", .subject = "ball", .lowest = 6e-5, .highest = 7e-5},
                     .value = 7.15e-5,
                     .passed = false}),
            "FAILED: final_volume of body `ball` is 71.5 ml, expected from 60 ml to 70 ml");
  expectation = {.quantity = "force", .subject = "probe", .at = 5, .lowest = -1, .highest = 9};
  EXPECT_FALSE(checked(expectation).results()[0].passed) << "what was not reached was not met";
}

TEST(ExpectationCheck, NoRunMeetsNothing) {
  const ExpectationCheck check({{.quantity = "final_force", .subject = "probe", .highest = 1}});
  EXPECT_FALSE(check.results()[0].passed);
}

TEST(ExpectationCheck, EveryWordMeasuresWhatItNames) {
  StepRecord record{.time = 0, .tools = {{.tool = "it", .phase = ""}}, .bodies = {{.body = "it"}}};
  record.points = {{.body = "it", .point = "it", .position = {4, 5, 6}, .stress_free = {1, 1, 2}}};
  record.tools[0].force = {1, 2, 2};
  record.bodies[0].pressure = 7;
  const auto measured = [&](const std::string& word) {
    ExpectationCheck check({{.quantity = word, .subject = "it"}});
    check.add(record);
    return check.results()[0].value;
  };
  for (const std::string& word : expectation_words()) {
    if (find_expectation_quantity(word).reduction != Reduction::kMoment) {
      EXPECT_TRUE(measured(word)) << word;
    }
  }
  EXPECT_EQ(measured("final_force"), 3);
  EXPECT_EQ(measured("final_pressure"), 7);
  EXPECT_EQ(measured("final_position_y"), 5);
  EXPECT_EQ(measured("final_displacement_y"), 4);
  EXPECT_DOUBLE_EQ(*measured("final_displacement"), std::sqrt(9. + 16 + 16));
}

TEST(ExpectationCheck, OnlyWholeWordsAreQuantities) {
  EXPECT_EQ(find_expectation_quantity("peakforce").measured, nullptr);
  EXPECT_EQ(find_expectation_quantity("x_force").measured, nullptr);
  EXPECT_EQ(find_expectation_quantity("").measured, nullptr);
}

}  // namespace
}  // namespace thinwall
