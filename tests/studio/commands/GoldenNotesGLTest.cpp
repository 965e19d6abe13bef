// What is told of goldens beside the results of comparisons.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/studio/commands/ProgramGLFixture.hpp"

namespace thinwall {
namespace {

TEST_F(ProgramGLTest, AListGoesOnPastAnApprovalThatIsDamaged) {
  write_bytes(folder_ / "scenes/another.yaml",
              small_scenario() + "golden: [ { at: 120 ms, max: 8, mean: 0.2, why: rounding } ]\n");
  std::filesystem::create_directories(folder_ / "golden_images/another");
  write_bytes(folder_ / "golden_images/another/approval.json", "{");
  const ProgramEnd end = run({"golden", "list", "--json"});
  EXPECT_EQ(end.exit_code, 2);
  const nlohmann::json result = nlohmann::json::parse(end.output);
  ASSERT_TRUE(result.contains("goldens")) << end.output;
  EXPECT_EQ(result.value("exit_code", -1), 2);
  EXPECT_EQ(result["goldens"][0]["scenario"], "small");
  EXPECT_NE(end.messages.find("another/approval.json:1:2: is damaged: the file ends in the middle"), std::string::npos)
      << end.messages;
}

TEST_F(ProgramGLTest, TheAdviceToRemoveAVideoNamesItsFilesFromAnyFolder) {
  write_bytes(folder_ / "scenes/small.yaml",
              small_scenario() + "golden:\n  - { video: 1, max: 8, mean: 0.2, why: rounding }\n");
  expect_good({"golden", "approve", "small", "--why", "the first"});
  write_bytes(folder_ / "scenes/small.yaml",
              small_scenario() + "golden:\n  - { at: 60 ms, max: 8, mean: 0.2, why: rounding }\n");
  const std::string messages = run({"golden", "list"}).messages;
  const std::string advice = "remove what belongs to it: git rm " + (folder_ / "golden_images/small/video").string();
  EXPECT_NE(messages.find(advice), std::string::npos) << messages;
}

TEST_F(ProgramGLTest, GoldensThatNoScenarioAsksForAnyMoreAreToldAndFailNothing) {
  const std::string two =
      "golden:\n  - { at: 60 ms, max: 8, mean: 0.2, why: rounding }\n"
      "  - { at: 120 ms, max: 8, mean: 0.2, why: rounding }\n";
  write_bytes(folder_ / "scenes/small.yaml", small_scenario() + two);
  expect_good({"golden", "approve", "small", "--why", "the first"});
  EXPECT_EQ(run({"golden", "list"}).messages, "");
  write_bytes(folder_ / "scenes/small.yaml", small_scenario() + two.substr(0, two.rfind("  - {")));
  std::filesystem::create_directory(folder_ / "golden_images/gone");
  write_bytes(folder_ / "golden_images/gone/at_1s.00000000.png", "a picture");
  write_bytes(folder_ / "golden_images/small/at_9s.00000000.png", "a picture");
  for (const char* verb : {"list", "test", "report"}) {
    const ProgramEnd end = run({"golden", verb, "--json"});
    EXPECT_EQ(end.exit_code, 0) << end.messages;
    for (const char* words : {"golden_images/small/at_0.12s.", "no golden of scenario small is at 0.12 s",
                              "at_9s.00000000.png: note: no approval names it", "golden_images/gone: ", "git rm -r"}) {
      EXPECT_NE(end.messages.find(words), std::string::npos) << verb << ": " << words << "\n" << end.messages;
    }
    EXPECT_EQ(nlohmann::json::parse(end.output)["notes"].size(), 3U) << end.output;
  }
  const std::string named = run({"golden", "test", "small"}).messages;
  EXPECT_EQ(named.find("golden_images/gone"), std::string::npos) << "what is not asked for is not told";
  EXPECT_NE(named.find("at_9s.00000000.png"), std::string::npos) << named;
  EXPECT_EQ(run({"golden", "test", "small@60ms"}).messages.find("no golden of"), std::string::npos);
}

TEST_F(ProgramGLTest, TheGoldensOfAScenarioThatIsRenamedAreToldToBeMovedWithTheirApprovals) {
  expect_good({"golden", "approve", "small", "--why", "the first"});
  std::filesystem::rename(folder_ / "scenes/small.yaml", folder_ / "scenes/large.yaml");
  write_bytes(folder_ / "scenes/other.yaml",
              small_scenario() + "golden: [ { at: 60 ms, max: 8, mean: 0.2, why: rounding } ]\n");
  const std::string before = (folder_ / "golden_images/small").string();
  const std::string after = (folder_ / "golden_images/large").string();
  const std::string moving = "if it is scenario large now, keep its approvals: git mv " + before + " " + after;
  for (const char* verb : {"list", "test"}) {
    const ProgramEnd end = run({"golden", verb});
    EXPECT_NE(end.messages.find(moving + "; else remove the folder: git rm -r " + before), std::string::npos)
        << end.messages;
    EXPECT_EQ(end.messages.find("if it is scenario other"), std::string::npos) << "it asks for another moment";
  }
  std::filesystem::rename(before, after);
  const ProgramEnd kept = run({"golden", "test", "large"});
  EXPECT_EQ(kept.exit_code, 0) << kept.messages;
  write_bytes(folder_ / "scenes/small.yaml", small_scenario());
  std::filesystem::rename(after, before);
  const ProgramEnd without = run({"golden", "list"});
  EXPECT_NE(without.messages.find("small.yaml asks for no goldens"), std::string::npos) << without.messages;
  EXPECT_EQ(without.messages.find("git mv"), std::string::npos) << "it is there";
}

}  // namespace
}  // namespace thinwall
