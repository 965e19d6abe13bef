// Each file of broken/ holds mistakes; the file beside it with the ending `expected` holds every message, in order.

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/material/WallLaw.hpp"
#include "engine/tool/Tool.hpp"
#include "studio/scenario/LoadScenario.hpp"
#include "studio/schema/Wording.hpp"
#include "tests/studio/scenario/ScenarioTestTools.hpp"

namespace thinwall {
namespace {

std::vector<std::string> broken_files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(scenario_test_folder() / "broken")) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

std::string without(std::string text, const std::string& part) {
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos;) text.erase(at, part.size());
  return text;
}

std::string laws_in_backticks() {
  std::vector<std::string> names;
  for (const WallLaw& law : wall_laws()) names.emplace_back(law.name);
  return list_in_backticks(names);
}

/// What is expected, with all laws and all kinds of tools in place of `{laws}` and `{tools}`, so that a new one does
/// not change it.
std::string filled(std::string text) {
  const std::string tools = list_in_backticks(std::vector<std::string>(kToolKindNames.begin(), kToolKindNames.end()));
  for (const auto& [mark, words] :
       {std::pair<std::string, std::string>{"{laws}", laws_in_backticks()}, {"{tools}", tools}}) {
    for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos;) text.replace(at, mark.size(), words);
  }
  return text;
}

class BrokenScenario : public testing::TestWithParam<std::string> {};

TEST_P(BrokenScenario, TellsAllItsMistakes) {
  const std::filesystem::path folder = scenario_test_folder() / "broken";
  const std::string expected = filled(read_file(folder / (GetParam() + ".expected")));
  ASSERT_FALSE(expected.empty());
  try {
    load_scenario(folder / (GetParam() + ".yaml"), {});
    FAIL() << "was read";
  } catch (const InputErrors& errors) {
    EXPECT_EQ(without(errors.what(), folder.string() + "/") + "\n", expected);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, BrokenScenario, testing::ValuesIn(broken_files()),
                         [](const testing::TestParamInfo<std::string>& file) { return file.param; });

}  // namespace
}  // namespace thinwall
