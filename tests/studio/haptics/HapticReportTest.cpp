#include "studio/haptics/HapticReport.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace thinwall {
namespace {

HapticTick tick(double time, double force) {
  HapticTick one{.time = time, .woken = 1e-5, .computed = 2e-5, .pose = {}};
  one.force = {0, 0, force};
  return one;
}

TEST(HapticReportTest, PercentilesAreThoseThatSoManyDoNotExceed) {
  std::vector<double> values;
  for (int k = 1000; k >= 1; --k) values.push_back(k);
  const Percentiles percentiles = percentiles_of(values);
  EXPECT_EQ(percentiles.p50, 500);
  EXPECT_EQ(percentiles.p99, 990);
  EXPECT_EQ(percentiles.p999, 999);
  EXPECT_EQ(percentiles.largest, 1000);
  EXPECT_EQ(percentiles_of({}).largest, 0);
}

TEST(HapticReportTest, TheErrorIsThatOfTheForceGivenLastBeforeEachMomentOfTheFullSolution) {
  const std::vector<HapticTick> ticks = {tick(0, 0), tick(1e-3, 1), tick(2e-3, 2), tick(4e-3, 5)};
  const ForceError error = force_error(
      ticks,
      {{.time = 1e-3, .force = {0, 0, 1.5}}, {.time = 3e-3, .force = {0, 0, 4}}, {.time = 9e-3, .force = {0, 0, 100}}});
  EXPECT_EQ(error.samples, 2);  // the loop had ended before the third
  EXPECT_EQ(error.largest, 2);
  EXPECT_EQ(error.at, 3e-3);
  EXPECT_EQ(error.largest_force, 4);
  EXPECT_EQ(error.largest_part(), 0.5);
  EXPECT_DOUBLE_EQ(error.root_mean_square, std::sqrt((0.25 + 4) / 2));
  EXPECT_EQ(largest_jump(ticks), 3);
}

TEST(HapticReportTest, SkippedTicksCountAsMissed) {
  HapticReport report{.scenario = "one", .tool = "probe", .forces = "local"};
  report.record.ticks = {tick(0, 0), tick(3e-3, 0)};
  report.record.ticks[0].missed = true;
  report.record.skipped = 2;
  EXPECT_NE(to_text(report).find("missed deadlines: 3 of 4"), std::string::npos) << to_text(report);
  const auto json = nlohmann::json::parse(to_json(report, 0));
  EXPECT_EQ(json["missed_deadlines"], 3);
  EXPECT_DOUBLE_EQ(json["latency"]["largest_ms"], 0.03);
}

TEST(HapticReportTest, TellsNumbersOnlyWhereNoSolutionHasComeYet) {
  HapticReport report{.scenario = "one", .tool = "probe", .forces = "local"};
  report.record.ticks = {tick(0, 0)};
  report.coarse_triangles = 2000;
  const auto json = nlohmann::json::parse(to_json(report, 0));
  EXPECT_EQ(json["full_solutions"]["count"], 0);
  EXPECT_EQ(json["full_solutions"]["mean_ms"], 0);
}

TEST(HapticReportTest, TheTableTellsTicksApartHoweverLongTheSession) {
  HapticRecord record;
  record.ticks = {tick(12345.678, 0), tick(12345.679, 0)};
  const std::string table = tick_table(record);
  EXPECT_NE(table.find("\n12345.678,"), std::string::npos) << table;
  EXPECT_NE(table.find("\n12345.679,"), std::string::npos) << table;
}

TEST(HapticReportTest, TellsThatRealTimeWasNotPermittedOnlyWhereItWasAskedFor) {
  HapticReport report;
  report.record.ticks = report.empty.ticks = {tick(0, 1)};
  EXPECT_NE(to_text(report).find("not permitted"), std::string::npos);
  report.asked_for_real_time = false;
  EXPECT_EQ(to_text(report).find("not permitted"), std::string::npos);
}

TEST(HapticReportTest, TellsWhatCameOfADriver) {
  HapticReport report;
  report.record.ticks = report.empty.ticks = {tick(0, 1)};
  EXPECT_EQ(to_text(report).find("driver:"), std::string::npos);
  EXPECT_FALSE(nlohmann::json::parse(to_json(report, 0)).contains("driver"));
  report.driver = PeerFigures{.poses = 500, .passed_over = 3, .undelivered = 2, .longest_silence = 0.02, .lost = 0.5};
  const std::string text = to_text(report);
  for (const char* part : {"500 poses", "silence 20.0 ms", "3 datagrams", "2 forces", "gone from 0.500 s on"}) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
  const auto json = nlohmann::json::parse(to_json(report, 0))["driver"];
  EXPECT_EQ(json["lost_at_s"], 0.5);
  EXPECT_EQ(json["undelivered_forces"], 2);
}

}  // namespace
}  // namespace thinwall
