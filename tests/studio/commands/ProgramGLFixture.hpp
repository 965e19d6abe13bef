#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/studio/commands/RunningProgram.hpp"

namespace thinwall {

/// Runs the program, which draws, in a folder of its own, where scenes/small.yaml has a golden.
class ProgramGLTest : public ::testing::Test {
 protected:
  ProgramGLTest() {
    std::filesystem::create_directory(folder_ / "scenes");
    write_bytes(folder_ / "scenes/small.yaml",
                small_scenario() + "golden: [ { at: 120 ms, max: 8, mean: 0.2, why: rounding of the driver } ]\n");
  }

  ProgramEnd run(const std::vector<std::string>& arguments) {
    return run_thinwall(
        arguments, {.folder = folder_.path(), .environment = {{"THINWALL_HOME", folder_.path()}, {"CI", "false"}}});
  }
  void expect_good(const std::vector<std::string>& arguments) {
    const ProgramEnd end = run(arguments);
    ASSERT_EQ(end.exit_code, 0) << end.messages;
  }
  nlohmann::json manifest(const std::string& out) const {
    return nlohmann::json::parse(file_bytes(folder_ / out / "manifest.json"));
  }

  TemporaryFolder folder_;
};

}  // namespace thinwall
