// The generated files of the format are as the table says, and the JSON Schema agrees with the reader.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "studio/schema/JsonSchema.hpp"
#include "studio/schema/ReferencePage.hpp"
#include "studio/schema/Schema.hpp"
#include "tests/studio/scenario/ScenarioTestTools.hpp"
#include "tests/studio/schema/SchemaForms.hpp"

namespace thinwall {
namespace {

const std::filesystem::path kScenes = std::filesystem::path(THINWALL_SOURCE_DIR) / "scenes";

TEST(GeneratedFiles, AreNotStale) {
  EXPECT_TRUE(read_file(kScenes / "scenario.schema.json") == scenario_json_schema())
      << "scenes/scenario.schema.json is stale; run scripts/format-reference";
  EXPECT_TRUE(read_file(kScenes / "FORMAT.md") == scenario_reference())
      << "scenes/FORMAT.md is stale; run scripts/format-reference";
}

TEST(GeneratedFiles, EveryKeyAndWordIsOnTheReferencePage) {
  const std::string page = scenario_reference();
  for (const SchemaForm& form : all_schema_forms()) {
    for (const KeySchema& key : form.keys()) {
      EXPECT_NE(page.find("| `" + key.key + "` |"), std::string::npos) << key.key;
      for (const std::string& word : key.value.words) EXPECT_NE(page.find("`" + word + "`"), std::string::npos) << word;
    }
  }
}

TEST(GeneratedFiles, ExamplesOfListsLeaveNoItemEmpty) {
  const std::string page = scenario_reference();
  for (const char* gap : {"[,", ", ,", ", ]"}) EXPECT_EQ(page.find(gap), std::string::npos) << gap;
}

/// A node as an editor sees it: plain numbers and booleans have their type.
nlohmann::json to_json(const TextNode& node) {
  nlohmann::json json;
  if (node.kind == NodeKind::kText) {
    json = nlohmann::json::parse(node.text, nullptr, false);
    if (json.is_discarded() || json.is_structured()) json = node.text;
  }
  if (node.kind == NodeKind::kList) json = nlohmann::json::array();
  if (node.kind == NodeKind::kMapping) json = nlohmann::json::object();
  for (const TextNode& item : node.items) json.push_back(to_json(item));
  for (const TextMember& member : node.members) json[member.key] = to_json(member.value);
  return json;
}

class JsonSchemaOfTheFormat : public testing::Test {
 protected:
  void SetUp() override {
    const nlohmann::json document = nlohmann::json::parse(scenario_json_schema());
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(valijson::adapters::NlohmannJsonAdapter(document), schema_);
  }

  bool allows(const std::string& text) {
    Diagnostics diagnostics;
    const nlohmann::json document = to_json(parse_text(text, diagnostics));
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(document), nullptr);
  }

  bool allows_file(const std::string& name) { return allows(read_file(scenario_test_folder() / name)); }

  valijson::Schema schema_;
};

TEST_F(JsonSchemaOfTheFormat, AllowsWhatTheReaderReads) {
  for (const std::string name :
       {"valid/minimal.yaml", "valid/contract.yaml", "valid/everything.yaml", "valid/parts/look.yaml"}) {
    const bool is_whole = name.find("parts") == std::string::npos;
    EXPECT_EQ(allows_file(name), is_whole) << name;
  }
  EXPECT_TRUE(allows("include: elsewhere.yaml\nbodies: { organ: { wall: { density: 1 g/cm^3 } } }\n"));
}

TEST_F(JsonSchemaOfTheFormat, RefusesUnknownKeysWordsAndKinds) {
  for (const std::string name :
       {"misspelled_keys", "misspelled_words", "wrong_kinds", "missing_keys", "bare_numbers", "out_of_range",
        "shape_keys", "version", "empty_values", "nothing_but_a_list", "surface_of_both_kinds"}) {
    EXPECT_FALSE(allows_file("broken/" + name + ".yaml")) << name;
  }
}

TEST_F(JsonSchemaOfTheFormat, RefusesEachMisspelledKeyOfTheMinimalScenario) {
  const std::string text = read_file(scenario_test_folder() / "valid/minimal.yaml");
  ASSERT_TRUE(allows(text));
  for (const std::string key : {"thinwall", "bodies", "surface", "wall", "thickness", "material", "law", "shape"}) {
    std::string changed = text;
    changed.insert(changed.find(key), "x");
    EXPECT_FALSE(allows(changed)) << key;
  }
}

}  // namespace
}  // namespace thinwall
