// What runs leave, say and end with where they cannot go on.

#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/mount.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>
#include <utility>

#include "studio/take/TakeReader.hpp"
#include "tests/studio/commands/ProgramFixture.hpp"

namespace thinwall {
namespace {

TEST_F(ProgramTest, AFolderThatAnotherRunWritesToIsBadUsageAndStaysAsItIs) {
  std::filesystem::create_directory(folder_ / "out");
  write_bytes(folder_ / "out" / "forces.csv", "of the other run");
  const int other = open((folder_ / "out" / ".in_use").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  expect_bad_usage({"run", "small.yaml", "--no-render", "--out", "out"}, "works in out; wait until it has ended");
  EXPECT_EQ(file_bytes(folder_ / "out" / "forces.csv"), "of the other run");
  close(other);
  EXPECT_EQ(run({"run", "small.yaml", "--no-render", "--out", "out"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / ".in_use"));
}

TEST_F(ProgramTest, AFolderThatCannotBeWrittenEndsWith4) {
  write_bytes(folder_ / "file", "");
  const ProgramEnd end = run({"run", "small.yaml", "--no-render", "--out", "file/out"});
  EXPECT_EQ(end.exit_code, 4);
  EXPECT_NE(end.messages.find("cannot make the folder file/out"), std::string::npos) << end.messages;
}

TEST_F(ProgramTest, NamedChambersAreRecordedInAFileOfTheirOwn) {
  std::string scenario =
      small_scenario() + "expect: [ { quantity: final_pressure, chamber: bladder, within: [0, 9 kPa] } ]\n";
  scenario.insert(scenario.find("    fixed:"),
                  "    contents: { pressure: 500 Pa, chambers: { bladder: { at: [0, 0, 5 mm] } } }\n");
  write_bytes(folder_ / "chambers.yaml", scenario);
  const ProgramEnd end = run({"run", "chambers.yaml", "--no-render", "--out", "out"});
  ASSERT_EQ(end.exit_code, 0) << end.messages;
  EXPECT_NE(end.messages.find("met: final_pressure of chamber `bladder` of body `organ`"), std::string::npos);
  const std::string rows = file_bytes(folder_ / "out" / "chambers.csv");
  EXPECT_TRUE(rows.starts_with("time_s,body,chamber,volume_m3,fluid_volume_m3,leaked_m3,pressure_Pa\n0,organ,bladder,"))
      << rows;
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), manifest("out").at("steps").get<long>() + 1);
  EXPECT_NE(rows.find(",0,500\n"), std::string::npos) << rows;
  run({"run", "small.yaml", "--no-render", "--out", "out"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "chambers.csv")) << "it would be of another run";
}

TEST_F(ProgramTest, WhatIsKnownOfABodyIsToldAlsoWhereItFindsNoEquilibrium) {
  std::string scenario = small_scenario();
  const auto set = [&](const std::string& before, const std::string& after) {
    scenario.replace(scenario.find(before), before.size(), after);
  };
  set("radius: 20 mm", "radius: 20 m");
  set("    fixed:", "    contents: { fluid: incompressible, pressure: 2 kPa }\n    fixed:");
  set("at: [0, 0, 20 mm]", "at: [0, 0, 20 m]");
  write_bytes(folder_ / "large.yaml", scenario);
  const ProgramEnd end = run({"run", "large.yaml", "--no-render", "--json", "--out", "large"});
  EXPECT_EQ(end.exit_code, 3) << end.messages;
  EXPECT_EQ(nlohmann::json::parse(end.output).at("exit_code"), 3);
  EXPECT_NE(end.messages.find("is 40 m across, which no organ is"), std::string::npos) << end.messages;
  EXPECT_NE(manifest("large").at("warnings").dump().find("is 40 m across"), std::string::npos);
}

TEST_F(ProgramTest, ThePlotOfForcesShowsBothTakesOfAComparison) {
  write_bytes(folder_ / "compared.yaml",
              small_scenario() + "comparison: { set: { bodies.organ.wall.thickness: 2 mm }, captions: [a, b] }\n");
  ASSERT_EQ(run({"run", "compared.yaml", "--no-render", "--out", "compared"}).exit_code, 0);
  ASSERT_EQ(run({"run", "small.yaml", "--no-render", "--out", "alone"}).exit_code, 0);
  EXPECT_EQ(file_bytes(folder_ / "compared/forces.csv"), file_bytes(folder_ / "alone/forces.csv"));
  EXPECT_NE(file_bytes(folder_ / "compared/forces.png"), file_bytes(folder_ / "alone/forces.png"));
}

TEST_F(ProgramTest, ASecondTakeThatGoesOnAfterTheFirstIsToldOf) {
  const auto messages_with = [&](const std::string& speed) {
    write_bytes(folder_ / "compared.yaml", small_scenario() + "comparison:\n  set: { \"timeline[1].palpate.speed\": " +
                                               speed + " }\n  captions: [a, b]\n");
    return run({"run", "compared.yaml", "--no-render", "--out", "compared"}).messages;
  };
  EXPECT_NE(messages_with("10 mm/s").find("note: the second take lasts "), std::string::npos);
  EXPECT_EQ(messages_with("40 mm/s").find("the second take lasts"), std::string::npos) << "it waits for the first";
}

TEST_F(ProgramTest, WhatIsWrongWithTheSurfaceOfASecondTakeIsToldByCheck) {
  const auto check = [&](const std::string& value) {
    write_bytes(folder_ / "compared.yaml", small_scenario() + "comparison:\n  set: { bodies.organ.surface.triangles: " +
                                               value + " }\n  captions: [a, b]\n");
    return run({"check", "compared.yaml"});
  };
  const ProgramEnd good = check("256");
  EXPECT_EQ(good.exit_code, 0) << good.messages;
  EXPECT_NE(good.messages.find("note: the second take: shape `hemisphere`: 256 triangles"), std::string::npos)
      << good.messages;
  write_bytes(folder_ / "thick.yaml",
              small_scenario() + "comparison: { set: { bodies.organ.wall.thickness: 300 mm }, captions: [a, b] }\n");
  expect_bad_usage({"check", "thick.yaml"}, "more than twice the surface's extent");
}

TEST_F(ProgramTest, WhatEndsACommandIsToldAsJsonTooWhereThatIsAskedFor) {
  write_bytes(folder_ / "file", "");
  write_bytes(folder_ / "bad.yaml", "thinwall: 1\nbodies: 3\n");
  const auto told = [&](std::vector<std::string> arguments) {
    arguments.push_back("--json");
    const ProgramEnd end = run(arguments);
    const nlohmann::json json = nlohmann::json::parse(end.output);
    EXPECT_EQ(json.at("exit_code"), end.exit_code);
    EXPECT_NE(end.messages.find(json.at("failure").get<std::string>()), std::string::npos) << end.messages;
    return json;
  };
  const nlohmann::json bad_input = told({"run", "bad.yaml"});
  EXPECT_EQ(bad_input.at("exit_code"), 2);
  EXPECT_EQ(bad_input.at("errors")[0].at("line"), 2);
  EXPECT_EQ(told({"run", "small.yaml", "--unknown"}).at("exit_code"), 2);
  EXPECT_EQ(told({"compare", "small.yaml", "bad.yaml", "--metric", "unknown"}).at("exit_code"), 2);
  EXPECT_EQ(told({"run", "small.yaml", "--no-render", "--out", "file/out"}).at("exit_code"), 4);
  EXPECT_EQ(run({"run", "bad.yaml"}).output, "");
}

TEST_F(ProgramTest, AFullDiskEndsWith4AndNothingLooksWhole) {
  std::filesystem::create_directory(folder_ / "disk");
  if (mount("tmpfs", (folder_ / "disk").c_str(), "tmpfs", 0, "size=64k") != 0) {
    GTEST_SKIP() << "only root can make a small disk to fill";
  }
  const ProgramEnd end = run({"run", "small.yaml", "--no-render", "--out", "disk/out"});
  const bool looks_finished = any_looks_finished("disk/out");
  umount((folder_ / "disk").c_str());
  EXPECT_EQ(end.exit_code, 4) << end.messages;
  EXPECT_NE(end.messages.find("No space left on device"), std::string::npos) << end.messages;
  EXPECT_FALSE(looks_finished);
}

TEST_F(ProgramTest, ALimitOnFileSizesIsLikeAFullDisk) {
  const ProgramEnd end = run({"run", "small.yaml", "--no-render", "--out", "out"},
                             {.folder = {}, .environment = {}, .largest_file = 8192});
  EXPECT_EQ(end.exit_code, 4) << end.messages;
  EXPECT_NE(end.messages.find("File too large"), std::string::npos) << end.messages;
  EXPECT_FALSE(any_looks_finished("out"));
}

TEST_F(ProgramTest, WithoutStandardStreamsItLeavesWhatItLeavesWithThem) {
  ASSERT_EQ(run({"run", "small.yaml", "--no-render", "--out", "first"}).exit_code, 0);
  const std::string command = "cd '" + folder_.path().string() +
                              "' && '" THINWALL_PROGRAM
                              "' run small.yaml --no-render --json --out second 0<&- 1>&- 2>&-";
  EXPECT_EQ(std::system(command.c_str()), 0);
  for (const char* file : {"take.h5", "forces.csv", "body.csv"}) {
    EXPECT_EQ(file_bytes(folder_ / "second" / file), file_bytes(folder_ / "first" / file)) << file;
  }
}

TEST_F(ProgramTest, ResultsThatStandardOutputDoesNotTakeEndWith4) {
  const std::string start = "cd '" + folder_.path().string() + "' && '" THINWALL_PROGRAM "' ";
  const auto end_of = [&](const std::string& command) {
    const int status = std::system((start + command + " >/dev/full 2>messages").c_str());
    const std::string messages = file_bytes(folder_ / "messages");
    const std::string words = "cannot write to standard output: No space left on device; free some space";
    EXPECT_NE(messages.find(words), std::string::npos) << messages;
    return WEXITSTATUS(status);
  };
  std::string many;  // whose results no buffer holds
  for (int i = 0; i < 100; ++i) many += " small.yaml";
  EXPECT_EQ(end_of("check small.yaml --json"), 4);
  EXPECT_EQ(end_of("check --json" + many), 4);
  EXPECT_EQ(end_of("run small.yaml --no-render --json --out out"), 4);
  for (const char* help : {"--help", "run --help", "--version"}) EXPECT_EQ(end_of(help), 4) << help;
  EXPECT_EQ(end_of("check --json none.yaml" + many), 2) << "what is wrong besides is the worse";
}

TEST_F(ProgramTest, MessagesThatStandardErrorDoesNotTakeChangeNoExitCode) {
  write_bytes(folder_ / "bad.yaml", "thinwall: 1\nbodies: 3\n");
  const std::string start = "cd '" + folder_.path().string() + "' && '" THINWALL_PROGRAM "' ";
  const auto end_of = [&](const std::string& command) {
    return WEXITSTATUS(std::system((start + command + " >output 2>/dev/full").c_str()));
  };
  EXPECT_EQ(end_of("check small.yaml"), 0);
  EXPECT_EQ(end_of("run small.yaml --no-render --out out"), 0);
  EXPECT_EQ(end_of("check bad.yaml --json"), 2);
  EXPECT_EQ(nlohmann::json::parse(file_bytes(folder_ / "output")).at("exit_code"), 2) << "results arrive";
}

TEST_F(ProgramTest, AnEmptyValueIsBadUsageAndNotTakenForAnAbsentOne) {
  const std::string words = ": its value is empty";
  expect_bad_usage({"run", "small.yaml", "--no-render", "--out", ""}, "--out" + words);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  expect_bad_usage({"run", "small.yaml", "--no-render", "--out="}, "--out");
  expect_bad_usage({"check", "small.yaml", ""}, "SCENARIO" + words);
  expect_bad_usage({"render", "take.h5", "--view", ""}, "--view" + words);
  expect_bad_usage({"compare", "a.png", "b.png", "--mask", ""}, "--mask" + words);
  expect_bad_usage({"golden", "test", "--out", ""}, "--out" + words);
  expect_bad_usage({"haptic", "small.yaml", "--for", ""}, "--for" + words);
}

TEST_F(ProgramTest, ADeviceThatIsNotThereEndsWith4) {
  const ProgramEnd end = run({"run", "small.yaml", "--device", "99", "--out", "out"});
  EXPECT_EQ(end.exit_code, 4) << end.messages;
  // The simulation may have ended before; its records are whole then, but the recording is not.
  for (const char* file : {"video.mp4", "poster.png", "manifest.json"}) {
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / file)) << file;
  }
}

std::string compared_scenario(const std::string& depth, const std::string& timeline = "") {
  return small_scenario(timeline) + "comparison: { set: { depth: " + depth + " }, captions: [one, two] }\n";
}

TEST_F(ProgramTest, ARunWithoutComparisonLeavesNoSecondTakeOfAnEarlierOne) {
  write_bytes(folder_ / "two.yaml", compared_scenario("4 mm"));
  ASSERT_EQ(run({"run", "two.yaml", "--no-render", "--out", "out"}).exit_code, 0);
  EXPECT_EQ(manifest("out")["files"].back(), "second_take");
  ASSERT_EQ(run({"run", "small.yaml", "--no-render", "--out", "out"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/second_take"));
  EXPECT_NE(manifest("out")["files"].back(), "second_take");
}

TEST_F(ProgramTest, ARunThatIsStoppedMixesItsSecondTakeWithNoEarlierRecording) {
  write_bytes(folder_ / "two.yaml", compared_scenario("4 mm"));
  ASSERT_EQ(run({"run", "two.yaml", "--no-render", "--out", "out"}).exit_code, 0);
  const std::string before = file_bytes(folder_ / "out/second_take/take.h5");
  write_bytes(folder_ / "other.yaml", compared_scenario("1 mm", "  - wait: { for: 1000 s }\n"));
  {
    RunningProgram program({"run", "other.yaml", "--no-render", "--out", "out"},
                           {.folder = folder_.path(), .environment = {}});
    const auto is_begun = [&](const char* name) {
      return std::filesystem::exists(folder_ / "out" / name / "take.unfinished.h5");
    };
    while (!is_begun("second_take.unfinished") && !is_begun("second_take")) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    program.send_signal(SIGTERM);
    EXPECT_EQ(program.wait().exit_code, 143);
  }
  EXPECT_EQ(manifest("out")["source"], "two.yaml");
  EXPECT_TRUE(file_bytes(folder_ / "out/second_take/take.h5") == before);
  ASSERT_EQ(run({"run", "small.yaml", "--no-render", "--out", "out"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/second_take.unfinished"));
}

TEST_F(ProgramTest, ABrokenTakeIsBadInput) {
  write_bytes(folder_ / "take.h5", "no take");
  expect_bad_usage({"render", "take.h5"}, "take.h5: this is no take");
}

TEST_F(ProgramTest, AnInterruptMidwayEndsWith130AndATerminateSignalWith143) {
  write_bytes(folder_ / "long.yaml", small_scenario("  - wait: { for: 1000 s }\n"));
  for (const auto& [signal, code] : {std::pair(SIGINT, 130), std::pair(SIGTERM, 143)}) {
    EXPECT_EQ(run_stopped_midway(folder_.path(), "long.yaml", signal).exit_code, code);
    EXPECT_FALSE(any_looks_finished("out"));
    // What was reached is still there to be looked at.
    const TakeReader take(folder_ / "out" / "take.unfinished.h5");
    EXPECT_FALSE(take.ending().complete);
    EXPECT_GT(take.times().size(), 10U);
    std::filesystem::remove_all(folder_ / "out");
  }
}

TEST_F(ProgramTest, ACheckEndsWhenItIsInterruptedAlsoWithinTheEquilibriumOfABody) {
  std::string fine = small_scenario();
  fine.insert(fine.find("    fixed:"), "    contents: { pressure: 500 Pa }\n");
  fine.replace(fine.find("triangles: 64"), 13, "triangles: 40000");
  write_bytes(folder_ / "fine.yaml", fine);
  std::vector<std::string> check_many(500, "small.yaml"), check_fine{"check", "fine.yaml"};
  check_many.insert(check_many.begin(), "check");
  // A warning stands before a body's equilibrium, which takes seconds here, and `good` behind it.
  for (const auto& [arguments, words] : {std::pair(check_fine, "warning"), std::pair(check_many, "good")}) {
    for (const auto& [signal, code] : {std::pair(SIGINT, 130), std::pair(SIGTERM, 143)}) {
      RunningProgram program(arguments, {.folder = folder_.path(), .environment = {}});
      program.wait_for_message(words);
      program.send_signal(signal);
      EXPECT_EQ(program.wait().exit_code, code) << words;
    }
  }
}

TEST_F(ProgramTest, AnInterruptSaysThatEarlierResultsAreGoneWhereTheyAre) {
  write_bytes(folder_ / "long.yaml", small_scenario("  - wait: { for: 1000 s }\n"));
  const std::string gone = "terminated; the earlier results in out had been removed";
  const auto terminated = [&] { return run_stopped_midway(folder_.path(), "long.yaml", SIGTERM).messages; };
  EXPECT_EQ(terminated().find(gone), std::string::npos);
  std::filesystem::remove_all(folder_ / "out");
  std::filesystem::create_directory(folder_ / "out");
  write_bytes(folder_ / "out" / "forces.csv", "of an earlier run");
  EXPECT_NE(terminated().find(gone), std::string::npos);
}

}  // namespace
}  // namespace thinwall
