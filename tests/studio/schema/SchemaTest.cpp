#include "studio/schema/Schema.hpp"

#include <gtest/gtest.h>

#include <set>

#include "engine/material/WallLaw.hpp"
#include "studio/scenario/UnitPass.hpp"
#include "tests/studio/scenario/ScenarioTestTools.hpp"
#include "tests/studio/schema/SchemaForms.hpp"

namespace thinwall {
namespace {

TEST(Schema, EveryKeyIsDocumentedAndThereOnce) {
  for (const SchemaForm& form : all_schema_forms()) {
    std::set<std::string> seen;
    for (const KeySchema& key : form.keys()) {
      EXPECT_TRUE(seen.insert(key.key).second) << form.name() << "." << key.key;
      EXPECT_FALSE(key.documentation.empty()) << form.name() << "." << key.key;
      EXPECT_FALSE(key.needed && key.fallback) << form.name() << "." << key.key;
    }
    EXPECT_FALSE(form.mapping->documentation.empty()) << form.name();
  }
}

TEST(Schema, EveryDefaultIsWhatItsKeyAsksFor) {
  for (const SchemaForm& form : all_schema_forms()) {
    for (const KeySchema& key : form.keys()) {
      if (!key.fallback || key.key == form.mapping->selector) continue;
      Diagnostics diagnostics;
      const std::string text = example_text(form, key.key, *key.fallback);
      unit_pass(parse_text(text, diagnostics), *form.mapping, diagnostics);
      EXPECT_EQ(short_texts(diagnostics.errors), std::vector<std::string>{}) << text;
    }
  }
}

TEST(Schema, TheLawsOfTheEngineAreTheWordsOfMaterial) {
  std::vector<std::string> laws;
  for (const WallLaw& law : wall_laws()) laws.emplace_back(law.name);
  std::vector<std::string> cases;
  for (const SchemaForm& form : all_schema_forms()) {
    if (form.mapping->name == "material") cases.push_back(form.chosen->word);
  }
  EXPECT_EQ(cases, laws);
}

TEST(Schema, RangesAreSaidInTheUnitOfTheExample) {
  EXPECT_EQ(range_text({.minimum = 0, .minimum_excluded = true}, "0.8 mm"), "greater than 0 mm");
  EXPECT_EQ(range_text({.minimum = 0, .maximum = 0.01}, "0.8 mm"), "from 0 mm to 10 mm");
  EXPECT_EQ(range_text({.maximum = 2, .maximum_excluded = true}, "1"), "less than 2");
  EXPECT_EQ(range_text({.minimum = 1, .maximum = 1}, "1"), "1");
  EXPECT_EQ(range_text({}, "1"), "");
}

}  // namespace
}  // namespace thinwall
