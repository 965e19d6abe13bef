#include <gtest/gtest.h>

#include "renderer/video/Program.hpp"
#include "studio/recorder/RecordCsv.hpp"
#include "tests/studio/commands/RunningProgram.hpp"

namespace thinwall {
namespace {

const std::filesystem::path kRoot = THINWALL_SOURCE_DIR;

std::string readme() {
  return file_bytes(kRoot / "README.md");
}

/// The contents of the page's blocks of code in a language, in order.
std::vector<std::string> blocks(const std::string& language) {
  const std::string text = readme();
  std::vector<std::string> found;
  const std::string mark = "```" + language + "\n";
  for (auto begin = text.find(mark); begin != std::string::npos; begin = text.find(mark, begin)) {
    begin += mark.size();
    found.push_back(text.substr(begin, text.find("```", begin) - begin));
  }
  return found;
}

TEST(ReadmeTest, HasExactlyTwoSetUpCommands) {
  ASSERT_FALSE(blocks("sh").empty());
  EXPECT_EQ(blocks("sh")[0], "scripts/thinwall run scenes/palpation_gallbladder.yaml\nscripts/test\n");
}

TEST(ReadmeTest, ItsScenariosAreGoodAndRun) {
  ASSERT_EQ(blocks("yaml").size(), 3U);
  const TemporaryFolder folder;
  write_bytes(folder / "balloon.yaml", blocks("yaml")[0]);
  write_bytes(folder / "cut.yaml", blocks("yaml")[1]);
  write_bytes(folder / "puncture.yaml", blocks("yaml")[2]);
  const ProgramSetting here{.folder = folder.path(), .environment = {}};
  const ProgramEnd checked = run_thinwall({"check", "balloon.yaml", "cut.yaml", "puncture.yaml"}, here);
  EXPECT_EQ(checked.exit_code, 0) << checked.messages;
  const ProgramEnd run = run_thinwall({"run", "balloon.yaml", "--no-render", "--set", "depth=9mm"}, here);
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  const ProgramEnd cut = run_thinwall({"run", "cut.yaml", "--no-render"}, here);
  EXPECT_EQ(cut.exit_code, 0) << cut.messages;
  const ProgramEnd puncture = run_thinwall({"run", "puncture.yaml", "--no-render"}, here);
  EXPECT_EQ(puncture.exit_code, 0) << puncture.messages;
}

TEST(ReadmeTest, TheScriptLeavesTheFolderOfScenesAndGoldensToWhoNamesOne) {
  const TemporaryFolder folder;
  for (const char* made : {"scripts", "bin"}) std::filesystem::create_directory(folder / made);
  std::filesystem::copy(kRoot / "scripts/thinwall", folder / "scripts/thinwall");
  write_bytes(folder / "scripts/build_functions", "build=$root\nbuild_targets() { :; }\n");
  write_bytes(folder / "bin/thinwall", "#!/bin/sh\nprintf '%s %s' \"$THINWALL_HOME\" \"$1\"\n");
  std::filesystem::permissions(folder / "bin/thinwall", std::filesystem::perms::owner_all);
  const std::string script = (folder / "scripts/thinwall").string();
  EXPECT_EQ(run_program({"env", "-u", "THINWALL_HOME", script, "golden"}).output, folder.path().string() + " golden");
  EXPECT_EQ(run_program({"env", "THINWALL_HOME=mine", script, "golden"}).output, "mine golden");
}

TEST(ReadmeTest, NamesTheColumnsOfTheForceRecord) {
  EXPECT_NE(readme().find("`" + forces_csv_header() + "`"), std::string::npos);
}

TEST(ReadmeTest, NamesEachCommandOfTheProgram) {
  const std::string help = run_thinwall({"--help"}).output;
  for (const std::string command : {"run", "check", "render", "still", "golden", "compare", "haptic", "doctor"}) {
    EXPECT_NE(help.find("  " + command + " "), std::string::npos) << command;
    EXPECT_NE(readme().find("`thinwall " + command), std::string::npos) << command;
  }
}

TEST(ReadmeTest, ItsLinksLeadSomewhere) {
  const std::string text = readme();
  int links = 0;
  for (auto place = text.find("]("); place != std::string::npos; place = text.find("](", place + 2)) {
    const std::string target = text.substr(place + 2, text.find(')', place) - place - 2);
    EXPECT_TRUE(std::filesystem::exists(kRoot / target)) << target;
    ++links;
  }
  EXPECT_GT(links, 5);
}

}  // namespace
}  // namespace thinwall
