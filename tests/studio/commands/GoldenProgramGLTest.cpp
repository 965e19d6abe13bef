// Golden images from the command line.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "tests/studio/commands/ProgramGLFixture.hpp"

namespace thinwall {
namespace {

TEST_F(ProgramGLTest, AGoldenIsMissingThenApprovedThenComparedThenFails) {
  EXPECT_EQ(run({"golden", "test"}).exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "golden_images")) << "a test wrote a golden";
  expect_good({"golden", "approve", "small", "--why", "the first"});
  const ProgramEnd twice = run({"golden", "test", "small", "scenes/small.yaml", "small@0.12s", "--json"});
  EXPECT_EQ(twice.exit_code, 0) << twice.messages;
  EXPECT_EQ(nlohmann::json::parse(twice.output)["counts"]["ok"], 2) << "once whole, and once of a moment";
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/golden/index.html")) << "it told what was missing before";
  write_bytes(
      folder_ / "scenes/small.yaml",
      small_scenario() + "lights: { key: 0.5 }\ngolden: [ { at: 120 ms, max: 8, mean: 0.2, why: rounding } ]\n");
  const ProgramEnd end = run({"golden", "test", "--json"});
  EXPECT_EQ(end.exit_code, 1);
  EXPECT_EQ(nlohmann::json::parse(end.output)["counts"]["failed"], 1);
  EXPECT_EQ(nlohmann::json::parse(end.output)["exit_code"], 1);
  EXPECT_NE(end.messages.find("cause: look changed, state identical: lights.key 0.5 instead of 1"), std::string::npos)
      << end.messages;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/golden/small/at_0.12s.difference.png"));
  EXPECT_EQ(nlohmann::json::parse(end.output)["goldens"][0]["changed"], "look");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/golden/index.html"));
}

TEST_F(ProgramGLTest, AGoldenThatCannotBeReadAndAScenarioThatCannotBeRunStopNoOther) {
  const std::string golden = "golden: [ { at: 120 ms, max: 8, mean: 0.2, why: rounding } ]\n";
  for (const char* name : {"another", "zet"}) {
    write_bytes(folder_ / "scenes" / (std::string(name) + ".yaml"), small_scenario() + golden);
  }
  expect_good({"golden", "approve", "another", "small", "zet", "--why", "the first"});
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "golden_images/another")) {
    if (entry.path().extension() == ".png") std::filesystem::resize_file(entry, 100);
  }
  write_bytes(folder_ / "scenes/small.yaml",
              small_scenario("  - palpate: { at: [0, 0, 100 mm], depth: 1 mm, direction: [1, 0, 0] }\n") + golden);
  for (const char* jobs : {"1", "3"}) {
    const ProgramEnd end = run({"golden", "test", "--all", "--json", "--jobs", jobs, "--junit", "junit.xml"});
    EXPECT_EQ(end.exit_code, 2) << end.messages;
    const nlohmann::json result = nlohmann::json::parse(end.output);
    EXPECT_EQ(result.value("exit_code", -1), 2);
    EXPECT_EQ(result["counts"]["broken"], 2);
    EXPECT_EQ(result["counts"]["ok"], 1) << end.messages;
    EXPECT_NE(end.messages.find("broken: another at 0.12 s: cannot read "), std::string::npos) << end.messages;
    EXPECT_NE(end.messages.find("small.yaml:"), std::string::npos) << end.messages;
  }
  EXPECT_NE(file_bytes(folder_ / "junit.xml").find("<error type=\"broken\" message=\"cannot read "), std::string::npos);
  EXPECT_NE(file_bytes(folder_ / "out/golden/index.html").find("misses body"), std::string::npos);
  EXPECT_EQ(run({"golden", "approve", "small", "zet", "--why", "again"}).exit_code, 2);
}

TEST_F(ProgramGLTest, AGoldenIsReviewedListedExplainedAndNotApprovedTwice) {
  const auto answer = [&](const std::string& answers, const std::vector<std::string>& arguments) {
    write_bytes(folder_ / "answers", answers);
    return run_thinwall(arguments, {.folder = folder_.path(),
                                    .environment = {{"THINWALL_HOME", folder_.path()}, {"CI", "false"}},
                                    .input = folder_ / "answers"});
  };
  EXPECT_EQ(answer("r\n", {"golden", "review"}).exit_code, 1);
  EXPECT_EQ(answer("", {"golden", "review"}).exit_code, 1) << "the end of the input is no approval";
  EXPECT_FALSE(std::filesystem::exists(folder_ / "golden_images"));
  EXPECT_EQ(answer("what\na\n\nit is right\n", {"golden", "review"}).exit_code, 0);
  const ProgramEnd twice = run({"golden", "approve", "small@120ms", "--why", "again"});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_NE(twice.messages.find("nothing of what was named has changed"), std::string::npos) << twice.messages;
  EXPECT_EQ(run({"golden", "approve", "small@130ms", "--why", "again"}).exit_code, 2);
  const ProgramEnd list = run({"golden", "list", "--json"});
  EXPECT_EQ(nlohmann::json::parse(list.output)["goldens"][0]["drivers"].size(), 1U);
  EXPECT_NE(run({"golden", "why", "small"}).output.find("it is right"), std::string::npos);
  EXPECT_EQ(run({"golden", "why"}).output, run({"golden", "why", "small"}).output)
      << "all are meant where none is named";
  expect_good({"golden", "report"});
  const ProgramEnd refused = run({"golden", "test", "--junit", "."});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.messages.find("--junit . is a folder; name a file"), std::string::npos) << refused.messages;
  EXPECT_EQ(refused.messages.find("unchanged since"), std::string::npos) << "only once all is compared";
  EXPECT_NE(run({"golden", "test", "--junit", "junit.xml"}).messages.find("unchanged since"), std::string::npos);
  EXPECT_NE(file_bytes(folder_ / "junit.xml").find("tests=\"1\" failures=\"0\""), std::string::npos);
  EXPECT_EQ(run({"golden", "test", "--all"}).messages.find("unchanged since"), std::string::npos);
}

TEST_F(ProgramGLTest, WhatIsApprovedAndWhyIsToldAsJsonTooWhereThatIsAskedFor) {
  const std::string goldens_asked =
      "golden:\n  - { at: 120 ms, max: 8, mean: 0.2, why: rounding }\n"
      "  - { at: 60 ms, max: 8, mean: 0.2, why: rounding }\n  - { video: 1, max: 8, mean: 0.2, why: coded }\n";
  write_bytes(folder_ / "scenes/small.yaml", small_scenario() + goldens_asked);
  const auto told = [&](const std::vector<std::string>& arguments) {
    const ProgramEnd end = run(arguments);
    const nlohmann::json json = nlohmann::json::parse(end.output);
    EXPECT_EQ(json.value("exit_code", -1), end.exit_code) << end.messages;
    return json;
  };
  const nlohmann::json first = told({"golden", "approve", "small@120ms", "--why", "the first", "--json"});
  ASSERT_EQ(first.at("goldens").size(), 1U);
  EXPECT_EQ(first["goldens"][0].at("outcome"), "golden missing");
  EXPECT_EQ(first["goldens"][0].at("approved"), true);
  EXPECT_EQ(first["goldens"][0].at("after").at("outcome"), "ok");
  const nlohmann::json both = told({"golden", "approve", "small@120ms", "small@video", "--why", "the film", "--json"});
  ASSERT_EQ(both.at("goldens").size(), 2U);
  EXPECT_EQ(both["goldens"][0].at("approved"), false) << "it was as approved";
  EXPECT_FALSE(both["goldens"][0].contains("after"));
  EXPECT_EQ(both["goldens"][1].at("approved"), true);
  EXPECT_EQ(told({"golden", "approve", "small@video", "--why", "again", "--json"}).at("result"), "failed");

  write_bytes(folder_ / "scenes/small.yaml", small_scenario() + "lights: { key: 0.5 }\n" + goldens_asked);
  const nlohmann::json goldens = told({"golden", "why", "small", "--json"}).at("goldens");
  ASSERT_EQ(goldens.size(), 3U);
  EXPECT_EQ(goldens[0].at("at_s"), 0.12);
  const nlohmann::json picture = goldens[0].at("approvals").at(0), video = goldens[2].at("approvals").at(0);
  EXPECT_EQ(picture.at("why"), "the first");
  EXPECT_TRUE(std::filesystem::exists(folder_ / picture.at("golden").get<std::string>())) << picture;
  EXPECT_EQ(picture.at("changes").at(0).at("key"), "lights.key");
  EXPECT_EQ(goldens[1].at("approvals"), nlohmann::json::array()) << "none is approved";
  EXPECT_EQ(goldens[2].at("video"), true);
  EXPECT_EQ(video.at("why"), "the film");
  EXPECT_EQ(video.at("changes").at(0).at("after"), "0.5");
}

TEST_F(ProgramGLTest, AGoldenThatDiffersWithinItsLimitsIsApprovedOnlyWhereItIsNamedItself) {
  const std::string limits = "golden: [ { at: 120 ms, max: 255, mean: 255, drift: 1, why: all is allowed } ]\n";
  write_bytes(folder_ / "scenes/small.yaml", small_scenario() + limits);
  expect_good({"golden", "approve", "small", "--why", "the first"});
  write_bytes(folder_ / "scenes/small.yaml", small_scenario() + "lights: { key: 0.5 }\n" + limits);
  const ProgramEnd whole = run({"golden", "approve", "small", "--why", "darker"});
  EXPECT_EQ(whole.exit_code, 2);
  EXPECT_NE(whole.messages.find("to approve it all the same, name each: small@0.12s"), std::string::npos)
      << whole.messages;
  EXPECT_EQ(run({"golden", "test"}).messages.find("ok: small at 0.12 s: equal"), std::string::npos);
  expect_good({"golden", "approve", "small@0.12s", "--why", "darker"});
  EXPECT_NE(run({"golden", "test"}).messages.find("ok: small at 0.12 s: equal"), std::string::npos);
  EXPECT_EQ(run({"golden", "approve", "small@0.12s", "--why", "again"}).exit_code, 2);
}

TEST_F(ProgramGLTest, AVideoThatFindsNoRoomOnTheDiskIsNoRegression) {
  const std::string goldens =
      "golden:\n  - { at: 120 ms, max: 8, mean: 0.2, why: rounding }\n  - { video: 1, max: 8, mean: 0.2, why: rounding "
      "}\n";
  write_bytes(folder_ / "scenes/small.yaml", small_scenario() + goldens);
  expect_good({"golden", "approve", "small", "--why", "the first"});
  std::filesystem::remove_all(folder_ / "out/golden/videos");
  write_bytes(folder_ / "out/golden/videos", "no folder can be made here");
  for (const char* command : {"test", "report"}) {
    const ProgramEnd end = run({"golden", command, "--all", "--junit", "junit.xml"});
    EXPECT_EQ(end.exit_code, 4) << end.messages;
    EXPECT_NE(end.messages.find("result missing: small the video: cannot "), std::string::npos) << end.messages;
    EXPECT_NE(file_bytes(folder_ / "junit.xml").find("<error type=\"result missing\""), std::string::npos);
    std::filesystem::remove(folder_ / "junit.xml");
  }
  EXPECT_EQ(run({"golden", "approve", "small@video", "--why", "again"}).exit_code, 4);
  write_bytes(folder_ / "scenes/small.yaml", small_scenario() + "lights: { key: 0.5 }\n" + goldens);
  EXPECT_EQ(run({"golden", "test"}).exit_code, 1) << "its picture has failed";
}

TEST_F(ProgramGLTest, WhatCannotBeWrittenForLookingLeavesTheResultsOfAll) {
  std::filesystem::copy_file(folder_ / "scenes/small.yaml", folder_ / "scenes/another.yaml");
  expect_good({"golden", "approve", "small", "--why", "the first"});
  std::filesystem::create_directories(folder_ / "out/golden/unchanged.json");
  const ProgramEnd good = run({"golden", "test", "small", "--all"});
  EXPECT_EQ(good.exit_code, 0) << good.messages;
  EXPECT_NE(good.messages.find("note: what is good is not remembered"), std::string::npos) << good.messages;
  write_bytes(folder_ / "out/golden/another", "no folder can be made here");
  std::filesystem::create_directories(folder_ / "out/golden/index.html");
  const ProgramEnd end = run({"golden", "test", "--all", "--junit", "junit.xml", "--json"});
  EXPECT_EQ(end.exit_code, 1) << end.messages;
  for (const char* words :
       {"golden missing: another at 0.12 s", "ok: small at 0.12 s: equal", "cannot make the folder out/golden/another",
        "cannot write out/golden/index.html", "1 ok, 0 failed, 0 result missing, 1 golden missing"}) {
    EXPECT_NE(end.messages.find(words), std::string::npos) << words << "\n" << end.messages;
  }
  const nlohmann::json result = nlohmann::json::parse(end.output);
  EXPECT_EQ(result["goldens"].size(), 2U);
  EXPECT_EQ(result["notes"].size(), 2U) << result["notes"];
  EXPECT_TRUE(std::filesystem::exists(folder_ / "junit.xml"));
  EXPECT_EQ(run({"golden", "report", "small"}).exit_code, 4) << "it is good, and has no page";
}

TEST_F(ProgramGLTest, ATestEndsWithWhatIsNotAsApprovedAndHowItIsApproved) {
  std::filesystem::copy_file(folder_ / "scenes/small.yaml", folder_ / "scenes/another.yaml");
  expect_good({"golden", "approve", "small", "--why", "the first"});
  EXPECT_EQ(run({"golden", "test", "small"}).messages.find("golden approve"), std::string::npos);
  std::string text = file_bytes(folder_ / "scenes/small.yaml");
  text.replace(text.find("A small hemisphere"), 18, "A hemisphere");
  write_bytes(folder_ / "scenes/small.yaml", text);
  const ProgramEnd end = run({"golden", "test", "--json"});
  const std::string closing =
      "failed: small@0.12s (overlay)\ngolden missing: another@0.12s\nwhere today's pictures are right: thinwall golden "
      "approve another@0.12s small@0.12s --why ...\n0 ok, 1 failed, 0 result missing, 1 golden missing, ";
  EXPECT_NE(end.messages.find(closing), std::string::npos) << end.messages;
  EXPECT_EQ(nlohmann::json::parse(end.output)["goldens"][1]["argument"], "small@0.12s");
}

TEST_F(ProgramGLTest, AReviewThatWaitsForAnAnswerCanBeInterrupted) {
  const std::filesystem::path answers = folder_ / "answers";
  ASSERT_EQ(mkfifo(answers.c_str(), 0600), 0);
  const int writer = open(answers.c_str(), O_RDWR | O_CLOEXEC);
  RunningProgram program({"golden", "review"}, {.folder = folder_.path(),
                                                .environment = {{"THINWALL_HOME", folder_.path()}, {"CI", "false"}},
                                                .input = answers});
  while (!std::filesystem::exists(folder_ / "out/golden/index.html")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  program.send_signal(SIGINT);
  // The end of the input would end it otherwise.
  std::this_thread::sleep_for(std::chrono::seconds(1));
  close(writer);
  EXPECT_EQ(program.wait().exit_code, 130);
}

TEST_F(ProgramGLTest, OtherProcessesLeaveNothingBesideWhatIsGood) {
  std::filesystem::copy_file(folder_ / "scenes/small.yaml", folder_ / "scenes/another.yaml");
  expect_good({"golden", "approve", "small", "another", "--why", "the first"});
  const ProgramEnd first = run({"golden", "test", "--jobs", "2"});
  EXPECT_EQ(first.exit_code, 0) << first.messages;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/golden/jobs"));
  EXPECT_NE(run({"golden", "test"}).messages.find("unchanged since"), std::string::npos);
}

/// The processes that compute the scenarios of a long test, once they do.
std::vector<pid_t> processes_of_long_test(const std::filesystem::path& folder) {
  std::vector<pid_t> processes;
  for (const char* name : {"one", "two"}) {
    std::string number;
    while (number.empty()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      number = file_bytes(folder / "out/golden/jobs" / name / ".in_use");
    }
    processes.push_back(std::stoi(number));
  }
  return processes;
}

RunningProgram long_test(const std::filesystem::path& folder) {
  for (const char* name : {"one", "two"}) {
    write_bytes(folder / "scenes" / (std::string(name) + ".yaml"),
                small_scenario("  - wait: { for: 5000 s }\n") +
                    "golden: [ { at: 5000 s, max: 8, mean: 0.2, why: rounding } ]\n");
  }
  return RunningProgram({"golden", "test", "one", "two", "--jobs", "2"},
                        {.folder = folder, .environment = {{"THINWALL_HOME", folder}}});
}

TEST_F(ProgramGLTest, AnInterruptEndsTheOtherProcessesOfATestAsWell) {
  RunningProgram program = long_test(folder_.path());
  const std::vector<pid_t> processes = processes_of_long_test(folder_.path());
  const auto begin = std::chrono::steady_clock::now();
  program.send_signal(SIGINT);
  EXPECT_EQ(program.wait().exit_code, 130);
  // Their 500 000 steps take many times as long, and an interrupted step some milliseconds.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(3));
  for (const pid_t process : processes) EXPECT_NE(kill(process, 0), 0) << "it has ended as well";
}

/// Whether a process has ended, or does within two seconds; who its parent is then may not have asked for its end.
bool has_ended(pid_t process) {
  const std::filesystem::path about = "/proc/" + std::to_string(process) + "/stat";
  for (int looks = 0; looks < 100; ++looks) {
    const std::string words = file_bytes(about);
    if (words.empty() || words.find(") Z ") != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

TEST_F(ProgramGLTest, ATestThatIsKilledLeavesNoProcessOfItsOwnBehind) {
  RunningProgram program = long_test(folder_.path());
  const std::vector<pid_t> processes = processes_of_long_test(folder_.path());
  program.send_signal(SIGKILL);
  program.wait();
  for (const pid_t process : processes) {
    EXPECT_TRUE(has_ended(process));
    kill(process, SIGKILL);
  }
}

TEST_F(ProgramGLTest, OfAScenarioWhoseMomentIsNamedNothingElseIsComparedApprovedOrRemembered) {
  write_bytes(folder_ / "scenes/small.yaml", small_scenario() +
                                                 "golden:\n  - { at: 60 ms, max: 8, mean: 0.2, why: rounding }\n"
                                                 "  - { at: 120 ms, max: 8, mean: 0.2, why: rounding }\n");
  expect_good({"golden", "approve", "small@120ms", "--why", "the first"});
  const ProgramEnd one = run({"golden", "test", "small@120ms", "--json"});
  EXPECT_EQ(one.exit_code, 0) << one.messages;
  EXPECT_EQ(nlohmann::json::parse(one.output)["goldens"].size(), 1U);
  const ProgramEnd all = run({"golden", "test", "small", "--json"});
  EXPECT_EQ(all.exit_code, 1);
  EXPECT_EQ(nlohmann::json::parse(all.output)["counts"]["golden missing"], 1);
}

TEST_F(ProgramGLTest, AScenarioThatCannotBeReadIsBrokenAndStopsNoOther) {
  const std::string golden = "golden: [ { at: 120 ms, max: 8, mean: 0.2, why: rounding } ]\n";
  expect_good({"golden", "approve", "small", "--why", "the first"});
  write_bytes(folder_ / "scenes/bad.yaml", "thinwall: 1\nbodies: 3\nlook: [\n" + golden);
  write_bytes(folder_ / "scenes/wrong.yaml", small_scenario("  - wiat: { for: 1 s }\n") + golden);
  const std::vector<std::string> options = {"--json", "--junit", "junit.xml"};
  for (const std::vector<std::string>& names : {std::vector<std::string>{}, {"bad", "wrong", "small"}}) {
    std::filesystem::remove(folder_ / "junit.xml");
    std::vector<std::string> arguments = {"golden", "test"};
    arguments.insert(arguments.end(), names.begin(), names.end());
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramEnd end = run(arguments);
    EXPECT_EQ(end.exit_code, 2) << end.messages;
    const nlohmann::json result = nlohmann::json::parse(end.output);
    EXPECT_EQ(result["counts"]["ok"], 1) << end.messages;
    EXPECT_EQ(result["counts"]["broken"], 2) << end.messages;
    const std::string junit = file_bytes(folder_ / "junit.xml");
    for (const char* words : {"<testsuite name=\"bad\" tests=\"1\" failures=\"0\" errors=\"1\"", "did you mean `wait`",
                              "<testcase classname=\"golden.wrong\" name=\"scenario\">", "bad.yaml:"}) {
      EXPECT_NE(junit.find(words), std::string::npos) << words << "\n" << junit;
    }
    EXPECT_NE(file_bytes(folder_ / "out/golden/index.html").find("bad as a whole"), std::string::npos);
  }
  EXPECT_EQ(run({"golden", "approve", "small", "bad", "--why", "again"}).exit_code, 2);
  const ProgramEnd alone = run({"golden", "test", "bad", "--junit", "build/results/alone.xml"});
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_NE(file_bytes(folder_ / "build/results/alone.xml").find("errors=\"1\""), std::string::npos) << alone.messages;
  const ProgramEnd nowhere = run({"golden", "test", "small", "--junit", "junit.xml/j.xml"});
  EXPECT_EQ(nowhere.exit_code, 4);
  EXPECT_EQ(nowhere.messages.find("ok: small"), std::string::npos) << "it is told at once";
  const ProgramEnd unnamed = run({"golden", "test", "small", "--junit", std::string(300, 'j')});
  EXPECT_EQ(unnamed.exit_code, 4);
  EXPECT_NE(unnamed.messages.find(": cannot write jjj"), std::string::npos) << unnamed.messages;
  EXPECT_EQ(unnamed.messages.find("ok: small"), std::string::npos) << "it is told at once";
}

TEST_F(ProgramGLTest, ADamagedApprovalOfAMomentLeavesReportAndSummaryOfTheVideo) {
  write_bytes(folder_ / "scenes/small.yaml", small_scenario() +
                                                 "golden:\n  - { at: 60 ms, max: 8, mean: 0.2, why: rounding }\n"
                                                 "  - { video: 1, max: 8, mean: 0.2, why: rounding }\n");
  expect_good({"golden", "approve", "small", "--why", "the first"});
  write_bytes(folder_ / "golden_images/small/approval.json", "{");
  const ProgramEnd end = run({"golden", "test", "--json"});
  EXPECT_EQ(end.exit_code, 2);
  EXPECT_NE(end.messages.find("1 ok, 0 failed, 0 result missing, 0 golden missing, 0 skipped, 1 broken"),
            std::string::npos)
      << end.messages;
  EXPECT_NE(
      file_bytes(folder_ / "out/golden/index.html").find("approval.json:1:2: is damaged: the file ends in the middle"),
      std::string::npos);
}

TEST_F(ProgramGLTest, TwoScenariosOfOneNameAreRefusedAndANameOfNoneIsTold) {
  std::filesystem::create_directories(folder_ / "other");
  std::filesystem::copy_file(folder_ / "scenes/small.yaml", folder_ / "other/small.yaml");
  const ProgramEnd end = run({"golden", "test", "small", "other/small.yaml"});
  EXPECT_EQ(end.exit_code, 2) << end.messages;
  EXPECT_NE(end.messages.find("have one name"), std::string::npos) << end.messages;
  const ProgramEnd none = run({"golden", "why", "smal"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.messages.find("no scenario of that name in"), std::string::npos) << none.messages;
  EXPECT_NE(none.messages.find("scenes, did you mean `small`?"), std::string::npos) << none.messages;
}

}  // namespace
}  // namespace thinwall
