#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "tests/studio/commands/ProgramFixture.hpp"

namespace thinwall {
namespace {

using HapticProgramTest = ProgramTest;

TEST_F(HapticProgramTest, TellsItsFiguresAndWhatTheHandWasGiven) {
  for (const char* forces : {"full", "local"}) {
    const ProgramEnd end = run({"haptic", "small.yaml", "--json", "--forces", forces, "--record", "new/ticks.csv"});
    ASSERT_EQ(end.exit_code, 0) << end.messages;
    const nlohmann::json report = nlohmann::json::parse(end.output);
    EXPECT_EQ(report.value("exit_code", -1), 0);
    EXPECT_EQ(report["forces"], forces);
    EXPECT_EQ(report["tool"], "probe");
    for (const char* figure : {"p50_ms", "p99_ms", "p99.9_ms", "largest_ms"}) {
      EXPECT_GT(report["latency"][figure], 0) << figure;
      EXPECT_TRUE(report["empty_loop_wake_up"].contains(figure)) << figure;
    }
    EXPECT_LE(report["latency"]["p50_ms"], report["latency"]["largest_ms"]);
    EXPECT_TRUE(report["missed_deadlines"].is_number());
    EXPECT_TRUE(report["largest_force_jump_N"].is_number());
    EXPECT_GT(report["force_error"]["largest_force_N"], 0);
    EXPECT_GT(report["force_error"]["samples"], 2);
    EXPECT_NE(end.messages.find("force error"), std::string::npos) << end.messages;
    const std::string table = file_bytes(folder_ / "new/ticks.csv");
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(table, '\n')), report["ticks"].get<std::size_t>() + 1);
  }
}

TEST_F(HapticProgramTest, TheForcesOfARunAreAHandsMotion) {
  ASSERT_EQ(run({"run", "small.yaml", "--no-render", "--out", "first"}).exit_code, 0);
  const ProgramEnd end = run({"haptic", "small.yaml", "--trajectory", "first/forces.csv", "--json"});
  ASSERT_EQ(end.exit_code, 0) << end.messages;
  EXPECT_GT(nlohmann::json::parse(end.output)["force_error"]["largest_force_N"], 0);
}

TEST_F(HapticProgramTest, TheDriverToCopyFromIsFeltAndEndsTheLoop) {
  const std::string socket = folder_ / "hand.socket";
  const std::string command = std::string(THINWALL_SOURCE_DIR) + "/scripts/haptic-driver '" + socket +
                              "' 0 0 0.03 0 0 0.018 0.5 > '" + (folder_ / "felt").string() + "'";
  int driver_end = -1;
  std::thread driver([&] { driver_end = std::system(command.c_str()); });
  const ProgramEnd end = run({"haptic", "small.yaml", "--json", "--peer", socket});
  driver.join();
  ASSERT_EQ(end.exit_code, 0) << end.messages;
  EXPECT_EQ(driver_end, 0);
  const nlohmann::json report = nlohmann::json::parse(end.output);
  EXPECT_GT(report["driver"]["poses"], 50);
  EXPECT_FALSE(report["driver"].contains("lost_at_s"));
  EXPECT_LT(report["duration_s"], 20) << "it went on without a driver";
  EXPECT_GT(report["force_error"]["largest_force_N"], 0);
  EXPECT_NE(file_bytes(folder_ / "felt").find("largest force 0."), std::string::npos) << file_bytes(folder_ / "felt");
}

TEST_F(HapticProgramTest, RefusesWhatMakesNoSense) {
  expect_bad_usage({"haptic"}, "SCENARIO is required");
  expect_bad_usage({"haptic", "small.yaml", "--forces", "strong"}, "auto, full, local");
  expect_bad_usage({"haptic", "small.yaml", "--for", "3 mm"}, "--for 3 mm: this is");
  expect_bad_usage({"haptic", "small.yaml", "--for", "-1s"}, "--for -1s: it must last longer than 0 s");
  expect_bad_usage({"haptic", "small.yaml", "--for", "0"}, "--for 0: it must last longer than 0 s");
  expect_bad_usage({"haptic", "small.yaml", "--tool", "spoon"}, "probe");
  expect_bad_usage({"haptic", "small.yaml", "--trajectory", "missing.csv"}, "missing.csv");
  expect_bad_usage({"haptic", "small.yaml", "--peer", "missing/socket"}, "missing/socket");
  expect_bad_usage({"haptic", "small.yaml", "--peer", "a", "--trajectory", "b"}, "--trajectory");
}

TEST_F(HapticProgramTest, TellsBeforeItBeginsThatAFolderForItsRecordCannotBeMade) {
  write_bytes(folder_ / "file", "");
  const ProgramEnd end = run({"haptic", "small.yaml", "--json", "--record", "file/ticks.csv"});
  EXPECT_EQ(end.exit_code, 4) << end.messages;
  EXPECT_EQ(end.messages.find("force error"), std::string::npos) << "it has begun:\n" << end.messages;
}

}  // namespace
}  // namespace thinwall
