// For every key of every mapping of the table: what happens when it is misspelled, missing, of the wrong kind, in the
// wrong unit, without a unit, or out of range.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "studio/scenario/UnitPass.hpp"
#include "tests/studio/scenario/ScenarioTestTools.hpp"
#include "tests/studio/schema/SchemaForms.hpp"

namespace thinwall {
namespace {

std::vector<std::string> errors_of(const SchemaForm& form, const std::string& text) {
  Diagnostics diagnostics;
  unit_pass(parse_text(text, diagnostics), *form.mapping, diagnostics);
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : diagnostics.errors) messages.push_back(diagnostic.message);
  return messages;
}

using Messages = std::vector<std::string>;

class SchemaMistakes : public testing::TestWithParam<SchemaForm> {
 protected:
  const SchemaForm& form() const { return GetParam(); }

  /// The messages when a key has another value.
  Messages with(const KeySchema& key, const std::string& value) const {
    return errors_of(form(), example_text(form(), key.key, value));
  }

  bool is_selector(const KeySchema& key) const { return key.key == form().mapping->selector; }
};

TEST_P(SchemaMistakes, TheExampleWithAllKeysIsRight) {
  EXPECT_EQ(errors_of(form(), example_text(form())), Messages{});
}

TEST_P(SchemaMistakes, AMisspelledKeyIsUnknownAndTheRightOneIsNamed) {
  for (const KeySchema& key : form().keys()) {
    // A name of one letter is like any other.
    if (is_selector(key) || key.key.size() == 1) continue;
    const std::string wrong = key.key + "_";
    const std::string text = example_text(form(), key.key, "1, " + wrong + ": 1");
    const Messages messages = errors_of(form(), text);
    const std::string expected = wrong + ": unknown key, did you mean `" + key.key + "`?";
    EXPECT_NE(std::ranges::find(messages, expected), messages.end()) << text;
  }
}

TEST_P(SchemaMistakes, AMissingKeyIsAnErrorOnlyWhenItIsNeeded) {
  for (const KeySchema& key : form().keys()) {
    // Without the word no case is known, which has tests of its own.
    if (is_selector(key)) continue;
    const Messages messages = with(key, "");
    if (key.needed) {
      ASSERT_EQ(messages.size(), 1U) << key.key;
      EXPECT_TRUE(messages[0].starts_with("`" + key.key + "` is missing: " + key.documentation)) << messages[0];
    } else {
      EXPECT_EQ(messages, Messages{}) << key.key;
    }
  }
}

TEST_P(SchemaMistakes, AValueOfAnotherKindIsAnErrorThatSaysWhatIsExpected) {
  for (const KeySchema& key : form().keys()) {
    const ValueSchema& value = key.value;
    const bool takes_mapping = value.kind == ValueKind::kMapping || value.kind == ValueKind::kNamedMappings ||
                               value.kind == ValueKind::kParameters || value.kind == ValueKind::kChanges;
    // Parameters are read by a pass of their own.
    if (value.kind == ValueKind::kParameters || value.kind == ValueKind::kChanges) continue;
    const bool takes_list = value.kind == ValueKind::kList || value.kind == ValueKind::kDirection;
    const std::string wrong = takes_mapping || takes_list ? "word" : "[1]";
    if (value.single) continue;
    const Messages messages = with(key, wrong);
    ASSERT_EQ(messages.size(), 1U) << key.key;
    EXPECT_TRUE(messages[0].starts_with(key.key + ": expected ")) << messages[0];
    EXPECT_TRUE(messages[0].ends_with(takes_mapping || takes_list ? "got `word`" : "got a list")) << messages[0];
  }
}

TEST_P(SchemaMistakes, NothingAsTheValueOfANeededPlainKeyIsAnError) {
  for (const KeySchema& key : form().keys()) {
    if (key.value.kind >= ValueKind::kList || is_selector(key)) continue;
    const Messages messages = with(key, "~");
    ASSERT_EQ(messages.size(), 1U) << key.key;
    EXPECT_TRUE(messages[0].ends_with("got nothing")) << messages[0];
  }
}

TEST_P(SchemaMistakes, AQuantityInTheWrongUnitNamesBothDimensions) {
  for (const KeySchema& key : form().keys()) {
    if (key.value.kind != ValueKind::kQuantity && key.value.kind != ValueKind::kInteger) continue;
    const Messages messages = with(key, "3 kg*m/s^3");
    ASSERT_EQ(messages.size(), 1U) << key.key;
    EXPECT_TRUE(messages[0].starts_with(key.key + ": expected " + expectation(key.value))) << messages[0];
    EXPECT_TRUE(messages[0].ends_with("got 3 kg*m/s^3, a quantity in kg*m/s^3")) << messages[0];
  }
}

TEST_P(SchemaMistakes, ABareNumberForAQuantityWithADimensionIsAnError) {
  for (const KeySchema& key : form().keys()) {
    if (key.value.kind != ValueKind::kQuantity || key.value.dimension == kDimensionless) continue;
    const Messages messages = with(key, "3");
    ASSERT_EQ(messages.size(), 1U) << key.key;
    EXPECT_TRUE(messages[0].ends_with("got 3 without a unit")) << messages[0];
  }
}

TEST_P(SchemaMistakes, AnInfiniteNumberIsAnError) {
  for (const KeySchema& key : form().keys()) {
    if (key.value.kind != ValueKind::kQuantity) continue;
    for (const std::string text : {".nan", "-.inf", "1e999"}) EXPECT_EQ(with(key, text).size(), 1U) << key.key << text;
  }
}

TEST_P(SchemaMistakes, ANumberBeyondEitherEndOfItsRangeIsAnErrorThatGivesTheRange) {
  for (const KeySchema& key : form().keys()) {
    const ValueSchema& value = key.value;
    const bool is_number = value.kind == ValueKind::kQuantity || value.kind == ValueKind::kInteger;
    if (!is_number) continue;
    const std::string unit = si_unit(value.dimension);
    for (const double end : {value.range.minimum, value.range.maximum}) {
      if (!std::isfinite(end)) continue;
      const double beyond = end + (end == value.range.minimum ? -1 : 1) * std::max(1.0, std::abs(end));
      const Messages messages = with(key, format_like(beyond, "1 " + unit));
      ASSERT_EQ(messages.size(), 1U) << key.key;
      EXPECT_TRUE(messages[0].ends_with(" is out of range, it must be " + range_text(value.range, value.example)))
          << messages[0];
    }
  }
}

TEST_P(SchemaMistakes, TheEndOfARangeIsAllowedUnlessItIsExcluded) {
  for (const KeySchema& key : form().keys()) {
    const ValueSchema& value = key.value;
    const bool is_number = value.kind == ValueKind::kQuantity || value.kind == ValueKind::kInteger;
    if (!is_number || !std::isfinite(value.range.minimum)) continue;
    const Messages messages = with(key, format_like(value.range.minimum, "1 " + si_unit(value.dimension)));
    EXPECT_EQ(messages.size(), value.range.minimum_excluded ? 1U : 0U) << key.key;
  }
}

TEST_P(SchemaMistakes, AMisspelledWordIsAnErrorThatNamesTheNearest) {
  for (const KeySchema& key : form().keys()) {
    if (key.value.kind != ValueKind::kWord || key.value.words[0].size() < 3) continue;
    const std::string wrong = key.value.words[0] + "z";
    const Messages messages = with(key, wrong);
    ASSERT_FALSE(messages.empty()) << key.key;
    EXPECT_EQ(messages[0], key.key + ": expected " + expectation(key.value) + ", got `" + wrong + "`, did you mean `" +
                               key.value.words[0] + "`?");
  }
}

INSTANTIATE_TEST_SUITE_P(Table, SchemaMistakes, testing::ValuesIn(all_schema_forms()),
                         [](const testing::TestParamInfo<SchemaForm>& form) {
                           std::string name = form.param.name();
                           std::ranges::replace_if(
                               name, [](char c) { return c == ' ' || c == '-'; }, '_');
                           return name + "_" + std::to_string(form.index);
                         });

}  // namespace
}  // namespace thinwall
