#include "studio/golden/GoldenHistory.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "studio/golden/GoldenApproval.hpp"

namespace thinwall {
namespace {

GoldenHistory history(std::size_t steps, double force_from_step_5 = 1, double time_step = 0.01) {
  GoldenHistory history;
  for (std::size_t step = 0; step < steps; ++step) {
    const double time = time_step * static_cast<double>(step);
    ToolRecord probe{.tool = "probe", .phase = "contact"};
    probe.force.z() = 3 * time * (step >= 5 ? force_from_step_5 : 1);
    BodyRecord organ{.body = "organ", .volume = 1e-5, .pressure = 100};
    Moment moment;
    moment.record = {.time = time, .tools = {probe}, .bodies = {organ}};
    add_step(history, step, moment);
  }
  return history;
}

TEST(GoldenHistory, ComesBackFromItsText) {
  const GoldenHistory written = history(20);
  const GoldenHistory read = parse_history(history_text(written), "h.csv");
  EXPECT_EQ(read.columns, written.columns);
  ASSERT_EQ(read.rows.size(), 20U);
  EXPECT_FALSE(compare_histories(read, written).changed);
  EXPECT_TRUE(compare_histories(read, written).comparable);
}

TEST(GoldenHistory, StaysSmallAndKeepsItsLastStep) {
  const GoldenHistory read = parse_history(history_text(history(2000)), "h.csv");
  EXPECT_LE(read.rows.size(), kHistoryRows + 1);
  EXPECT_EQ(read.rows.back().step, 1999U);
  EXPECT_FALSE(compare_histories(read, history(2000)).changed);
}

TEST(GoldenHistory, NamesTheFirstStepTheQuantityAndTheAmount) {
  const HistoryChange change = compare_histories(history(20), history(20, 1.031));
  EXPECT_TRUE(change.changed);
  EXPECT_EQ(change.step, 5U);
  EXPECT_DOUBLE_EQ(change.time, 0.05);
  EXPECT_EQ(change.quantity, "probe.force_N");
  EXPECT_EQ(change.sentence,
            "from step 5 on (0.05 s), first in the force of probe; at 0.19 s the force of probe is 0.5877 N instead of "
            "0.57 N (+3.1 %)");
}

TEST(GoldenHistory, OtherTimeStepsAreComparedAtTheSameTimes) {
  const GoldenHistory golden = parse_history(history_text(history(20, 1, 0.3)), "h.csv");
  EXPECT_FALSE(compare_histories(golden, history(39, 1, 0.15)).changed);
  const HistoryChange change = compare_histories(golden, history(39, 2, 0.15));
  EXPECT_DOUBLE_EQ(change.time, 0.9);
  EXPECT_NE(change.sentence.find("at 5.7 s the force of probe is 34.2 N instead of 17.1 N (+100 %)"), std::string::npos)
      << change.sentence;
}

TEST(GoldenHistory, AChangeOfTheSecondTakeAloneIsToldAsSuch) {
  const auto pair = [](double force) {
    GoldenHistory history;
    for (std::size_t step = 0; step < 3; ++step) {
      Moment second;
      second.record.tools = {{.tool = "probe", .phase = "contact"}};
      second.record.tools[0].force.z() = step == 2 ? force : 0.1;
      Moment moment;
      moment.record = {
          .time = 0.1 * static_cast<double>(step), .tools = {{.tool = "probe", .phase = "contact"}}, .bodies = {}};
      moment.second = std::make_shared<const Moment>(second);
      add_step(history, step, moment);
    }
    return history;
  };
  EXPECT_FALSE(compare_histories(pair(0.2), pair(0.2)).changed);
  const HistoryChange change = compare_histories(pair(0.2), pair(0.25));
  EXPECT_EQ(change.quantity, "second_take.probe.force_N");
  EXPECT_EQ(
      change.sentence,
      "from step 2 on (0.2 s), first in the force of probe in the second take; at 0.2 s the force of probe in the "
      "second take is 0.25 N instead of 0.2 N (+25 %)");
}

TEST(GoldenHistory, WhatEndsAsBeforeIsToldOfTheStepWhereItDiffersMost) {
  GoldenHistory today = history(20, 1.031);
  today.rows[12].values[0] *= 2;
  today.rows.back() = history(20).rows.back();
  const HistoryChange change = compare_histories(history(20), today);
  EXPECT_EQ(change.step, 5U);
  EXPECT_NE(change.sentence.find("; at 0.12 s the force of probe is"), std::string::npos) << change.sentence;
}

TEST(GoldenHistory, NoPartsAreTakenOfWhatWasRounding) {
  const HistoryChange change = compare_histories(history(20, 1e-13), history(20));
  EXPECT_NE(change.sentence.find("instead of 5.7e-14 N"), std::string::npos) << change.sentence;
  EXPECT_EQ(change.sentence.find(" %)"), std::string::npos) << change.sentence;
}

TEST(GoldenHistory, RoundingOfOtherMachinesIsNoChange) {
  EXPECT_FALSE(compare_histories(history(20), history(20, 1 + 1e-7)).changed);
  EXPECT_TRUE(compare_histories(history(20), history(20, 1 + 1e-4)).changed);
}

GoldenHistory history_with_friction(double friction, double elastic) {
  GoldenHistory history;
  for (std::size_t step = 0; step < 3; ++step) {
    Moment moment;
    moment.record = {.time = 0.1 * static_cast<double>(step),
                     .tools = {},
                     .bodies = {{.body = "organ", .volume = 1e-5, .elastic = elastic, .friction = friction}}};
    add_step(history, step, moment);
  }
  return history;
}

TEST(GoldenHistory, WhatRoundingLeavesIsNoChange) {
  const auto changes = [](double before, double after, double elastic) {
    return compare_histories(history_with_friction(before, elastic), history_with_friction(after, elastic)).changed;
  };
  EXPECT_FALSE(changes(1.7e-29, 1.9e-29, 1e-3)) << "beside the energy of the wall";
  EXPECT_FALSE(changes(1.7e-14, 1.9e-14, 1e-3)) << "what sums that cancel leave of it";
  EXPECT_FALSE(changes(1.7e-29, 1.9e-29, 0)) << "of a wall at rest";
  EXPECT_FALSE(changes(0, 1.9e-29, 1e-3)) << "where there was none";
  EXPECT_TRUE(changes(1.7e-9, 1.9e-9, 1e-3)) << "a small part of the wall's energy is one";
  EXPECT_TRUE(changes(0, 1e-6, 1e-3)) << "what is new is one";
}

TEST(GoldenHistory, AllThatIsLostCountsAsSpent) {
  BodyRecord organ{.body = "organ"};
  organ.viscous = 1;
  organ.friction = 2;
  organ.fracture = 4;
  organ.leak = 8;
  organ.jump = 16;
  Moment moment;
  moment.record.bodies = {organ};
  GoldenHistory history;
  add_step(history, 0, moment);
  const auto column = std::ranges::find(history.columns, "organ.spent_energy_J") - history.columns.begin();
  ASSERT_LT(static_cast<std::size_t>(column), history.columns.size());
  EXPECT_EQ(history.rows[0].values[static_cast<std::size_t>(column)], 31);
}

GoldenHistory history_with_depth(double depth, double contact_area, double volume) {
  GoldenHistory history;
  Moment moment;
  ToolRecord probe;
  probe.tool = "probe";
  probe.depth = depth;
  probe.contact_area = contact_area;
  moment.record = {.time = 0.1, .tools = {probe}, .bodies = {{.body = "organ", .volume = volume}}};
  add_step(history, 1, moment);
  return history;
}

TEST(GoldenHistory, ASmallChangeIsToldInAsManyDigitsAsShowIt) {
  const HistoryChange change =
      compare_histories(history_with_friction(1e-3, 2e-3), history_with_friction(1.00006e-3, 2e-3));
  EXPECT_NE(change.sentence.find("0.00100006 J instead of 0.001 J"), std::string::npos) << change.sentence;
}

TEST(GoldenHistory, DepthsAreasAndVolumesOfRoundingAloneAreNoChange) {
  const GoldenHistory golden = history_with_depth(1.735e-18, 1e-17, 2e-20);
  EXPECT_FALSE(compare_histories(golden, history_with_depth(8.674e-19, 3e-17, -1e-20)).changed)
      << "of a tool that has come back to where it touched, on an open sheet";
  EXPECT_TRUE(compare_histories(golden, history_with_depth(1e-9, 1e-17, 2e-20)).changed);
  EXPECT_TRUE(compare_histories(golden, history_with_depth(1.735e-18, 1e-12, 2e-20)).changed);
  EXPECT_TRUE(compare_histories(golden, history_with_depth(1.735e-18, 1e-17, 1e-15)).changed);
}

TEST(GoldenHistory, OtherQuantitiesCannotBeCompared) {
  GoldenHistory other = history(20);
  other.columns[0] = "blade.force_N";
  EXPECT_FALSE(compare_histories(history(20), other).comparable);
}

TEST(GoldenHistory, ABrokenTextIsAnErrorThatNamesTheFile) {
  EXPECT_THROW(parse_history("nothing", "h.csv"), GoldenError);
  EXPECT_THROW(parse_history("step,time_s,a\n1,2\n", "h.csv"), GoldenError);
  EXPECT_THROW(parse_history("step,time_s,a\n1,2,x\n", "h.csv"), GoldenError);
  EXPECT_THROW(parse_history("step,time_s,a\n1,2,3", "h.csv"), GoldenError) << "it may have gone on with more digits";
  // With such a number all others would count as unchanged.
  EXPECT_THROW(parse_history("step,time_s,a\n1,2,nan\n", "h.csv"), GoldenError);
  EXPECT_THROW(parse_history("step,time_s,a\n1,inf,3\n", "h.csv"), GoldenError);
  EXPECT_THROW(parse_history("step,time_s,a\n-1,2,3\n", "h.csv"), GoldenError);
  EXPECT_THROW(parse_history("step,time_s,a\n1.5,2,3\n", "h.csv"), GoldenError);
}

}  // namespace
}  // namespace thinwall
