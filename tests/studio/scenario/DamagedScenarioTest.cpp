// Damaged and hostile files are read or refused with messages; nothing else happens.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "studio/scenario/LoadScenario.hpp"
#include "tests/studio/scenario/ScenarioTestTools.hpp"

namespace thinwall {
namespace {

std::vector<std::filesystem::path> files_in(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(scenario_test_folder() / folder)) {
    if (entry.is_regular_file() && entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// Loads and checks that any refusal has places and messages of one line; true when the file was read.
bool load(const std::filesystem::path& file) {
  try {
    load_scenario(file, {});
    return true;
  } catch (const InputErrors& errors) {
    EXPECT_FALSE(errors.diagnostics().empty());
    for (const Diagnostic& diagnostic : errors.diagnostics()) {
      EXPECT_GE(diagnostic.location.line, 1);
      EXPECT_GE(diagnostic.location.column, 1);
      EXPECT_FALSE(diagnostic.message.empty());
      EXPECT_EQ(diagnostic.message.find('\n'), std::string::npos) << diagnostic.message;
    }
    return false;
  }
}

TEST(DamagedScenario, FilesThatOnceDidHarmAreRefused) {
  for (const std::filesystem::path& file : files_in("corpus")) EXPECT_FALSE(load(file)) << file;
}

/// Changes a text in a few places: bytes, pieces taken out, doubled or moved, and words that mean something in YAML.
std::string damaged(std::string text, std::mt19937& random) {
  static const std::vector<std::string> words = {
      "{",    "}",   "[",    "]",  ": ",   "- ",        "\n",     "\"", "'",    "&a ",     "*a ", "${",
      "${a}", "!!x", "? ",   "| ", "#",    "\t",        "---",    "~",  ".nan", "1e9",     "0 ",  "-",
      "mm",   "%",   "\xff", "@",  "<<: ", "include: ", "mesh: ", ",",  "\r",   "\xc3\xa9"};
  const auto below = [&](std::size_t count) { return count == 0 ? 0 : random() % count; };
  const std::size_t changes = 1 + below(4);
  for (std::size_t change = 0; change < changes; ++change) {
    const std::size_t at = below(text.size());
    const std::size_t length = below(std::min<std::size_t>(40, text.size() - at) + 1);
    const std::string piece = text.substr(at, length);
    switch (below(4)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(below(text.size()), piece);
        break;
      case 2:
        text.insert(at, words[below(words.size())]);
        break;
      default:
        if (!text.empty()) text[at] = static_cast<char>(below(256));
    }
  }
  return text;
}

TEST(DamagedScenario, AnyDamageIsReadOrRefusedAndNeverCrashes) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "thinwall_damaged_scenario_test";
  std::filesystem::remove_all(folder);
  std::filesystem::copy(scenario_test_folder() / "valid", folder, std::filesystem::copy_options::recursive);
  std::vector<std::string> seeds;
  for (const std::string part : {"valid", "broken"}) {
    // Right files are few and the more telling ones.
    const std::size_t weight = part == "valid" ? 10 : 1;
    for (const std::filesystem::path& file : files_in(part)) seeds.insert(seeds.end(), weight, read_file(file));
  }
  // A fixed seed makes a failure come back.
  std::mt19937 random(20);
  int read = 0;
  constexpr int kTrials = 1500;
  for (int trial = 0; trial < kTrials; ++trial) {
    const std::filesystem::path file = folder / "damaged.yaml";
    const std::string text = damaged(seeds[random() % seeds.size()], random);
    std::ofstream(file, std::ios::binary) << text;
    ASSERT_NO_THROW(read += load(file) ? 1 : 0) << text;
  }
  std::filesystem::remove_all(folder);
  // Damage to comments and texts leaves some right; were it none or all, the damage would test nothing.
  EXPECT_GT(read, 0);
  EXPECT_LT(read, kTrials / 2);
}

}  // namespace
}  // namespace thinwall
