#include "studio/scenario/LateTimes.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

Scenario with_times(double time) {
  Scenario scenario;
  scenario.simulation.time_step = 0.01;
  scenario.view.cuts = {{.time = time}};
  scenario.view.highlights = {{.begin = time}};
  scenario.teaching.annotations.labels = {{.span = {.begin = 0}}, {.span = {.begin = time}}};
  scenario.teaching.annotations.arrows = {{.span = {.begin = time}}};
  scenario.teaching.annotations.force_arrows = {{.span = {.begin = time}}};
  scenario.teaching.freezes = {{.at = time}};
  scenario.teaching.slow_motions = {{.begin = time, .end = time + 1}};
  scenario.goldens = {{.at = time}};
  scenario.bodies.resize(1);
  scenario.bodies[0].name = "organ";
  scenario.bodies[0].loads = {{}, {.over = {{0, 0}, {time, 1}}}};
  scenario.expectations = {{.at = time}, {.from = time}, {.until = time}, {}};
  return scenario;
}

TEST(LateTimes, EachTimeAfterTheEndIsToldWithItsPath) {
  const std::vector<std::string> notes = late_times(with_times(50), 1.8);
  const std::string after = ": 50 s is after the end of the run, which is planned for 1.8 s; ";
  EXPECT_EQ(notes,
            (std::vector<std::string>{
                "cuts[1].at" + after + "it is never shown",
                "bodies.organ.loads[2].over[2]" + after + "the load does not get there",
                "teaching.labels[2].from" + after + "it is never shown",
                "teaching.arrows[1].from" + after + "it is never shown",
                "teaching.force_arrows[1].from" + after + "it is never shown",
                "teaching.highlights[1].from" + after + "it is never shown",
                "teaching.freezes[1].at" + after + "the video never stands still for it",
                "teaching.slow_motion[1].from" + after + "no part of the video has its speed",
                "golden[1].at" + after + "there is no picture of it", "expect[1].at" + after + "it cannot be met",
                "expect[2].from" + after + "it cannot be met", "expect[3].until" + after + "it cannot be met"}));
}

TEST(LateTimes, WhatIsWithinTheRunOrItsLastStepIsNotTold) {
  EXPECT_TRUE(late_times(with_times(1.8), 1.8).empty());
  EXPECT_TRUE(late_times(with_times(1.805), 1.8).empty());
}

}  // namespace
}  // namespace thinwall
