// The page of laws and numbers for tissue says what can be simulated.

#include <gtest/gtest.h>

#include "studio/scenario/LoadScenario.hpp"
#include "tests/studio/TemporaryFolder.hpp"
#include "tests/studio/scenario/ScenarioTestTools.hpp"

namespace thinwall {
namespace {

/// The contents of the page's blocks of YAML.
std::vector<std::string> snippets() {
  const std::string page = read_file(std::filesystem::path(THINWALL_SOURCE_DIR) / "scenes/TISSUES.md");
  const std::string opening = "```yaml\n", closing = "```";
  std::vector<std::string> found;
  for (std::size_t at = 0; (at = page.find(opening, at)) != std::string::npos;) {
    at += opening.size();
    const std::size_t end = page.find(closing, at);
    found.push_back(page.substr(at, end - at));
    at = end;
  }
  return found;
}

TEST(Tissues, EveryMaterialOfThePageLoads) {
  const TemporaryFolder folder;
  const std::vector<std::string> materials = snippets();
  ASSERT_EQ(materials.size(), 5U);
  for (const std::string& material : materials) {
    write_bytes(folder / "scene.yaml",
                "thinwall: 1\n"
                "bodies:\n"
                "  tissue:\n"
                "    surface: { shape: sheet }\n"
                "    contents: { fluid: none }\n"
                "    wall:\n"
                "      thickness: 1 mm\n"
                "      fibres: { along: [1, 0, 0] }\n"
                "      " +
                    material);
    const Scenario scenario = load_scenario(folder / "scene.yaml", {});
    const Material& read = scenario.bodies[0].material;
    EXPECT_GT(read.law->initial_modulus(read.parameters), 0) << material;
  }
}

}  // namespace
}  // namespace thinwall
