#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/studio/commands/RunningProgram.hpp"

namespace thinwall {

/// Runs the program in a folder of its own, where small.yaml is.
class ProgramTest : public ::testing::Test {
 protected:
  ProgramTest() { write_bytes(folder_ / "small.yaml", small_scenario()); }

  ProgramEnd run(const std::vector<std::string>& arguments, ProgramSetting setting = {}) {
    setting.folder = folder_.path();
    // The tests themselves may run in CI, where the program refuses what a person must do.
    setting.environment.insert({"CI", "false"});
    return run_thinwall(arguments, setting);
  }
  void expect_bad_usage(const std::vector<std::string>& arguments, const std::string& words) {
    const ProgramEnd end = run(arguments);
    EXPECT_EQ(end.exit_code, 2) << end.messages;
    EXPECT_NE(end.messages.find(words), std::string::npos) << end.messages;
  }
  bool any_looks_finished(const std::string& name) const {
    if (!std::filesystem::exists(folder_ / name)) return false;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / name)) {
      if (entry.path().filename().string().find(".unfinished") == std::string::npos) return true;
    }
    return false;
  }
  nlohmann::json manifest(const std::string& out) const {
    return nlohmann::json::parse(file_bytes(folder_ / out / "manifest.json"));
  }

  TemporaryFolder folder_;
};

}  // namespace thinwall
