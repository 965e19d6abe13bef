#include "engine/material/WallLaw.hpp"
#include "studio/schema/SchemaSections.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// The engine's sentence as a phrase like the others of the table.
std::string phrase(std::string_view sentence) {
  std::string words(sentence);
  if (words.ends_with('.')) words.pop_back();
  const bool begins_with_name = words.substr(0, words.find(' ')).ends_with("'s");
  if (!begins_with_name && words[0] >= 'A' && words[0] <= 'Z') words[0] = static_cast<char>(words[0] - 'A' + 'a');
  return words;
}

/// The keys of a law's parameters.
std::vector<KeySchema> parameter_keys(const WallLaw& law) {
  std::vector<KeySchema> keys;
  for (const LawParameter& parameter : law.parameters) {
    const Dimension dimension = parameter.unit.empty() ? kDimensionless : parse_unit(parameter.unit).dimension;
    const Range range{
        .minimum = parameter.minimum, .maximum = parameter.maximum, .minimum_excluded = parameter.minimum_excluded};
    const std::string example = dimension == kDimensionless ? "0.3" : dimension == kAngle ? "30 deg" : "20 kPa";
    std::optional<std::string> fallback;
    if (parameter.fallback) fallback = format_like(*parameter.fallback, dimension_example(dimension));
    ValueSchema value = quantity_value(dimension, range, example);
    if (dimension == kPressure) value = usually(std::move(value), kUsualModuli);
    keys.push_back({std::string(parameter.name), field_schema(std::move(value)), !parameter.fallback, fallback,
                    phrase(parameter.documentation)});
  }
  return keys;
}

}  // namespace

ValueSchema material_schema() {
  MappingSchema material{.name = "material", .documentation = "How the wall resists stretch."};
  material.selector = "law";
  std::vector<std::string> words;
  for (const WallLaw& law : wall_laws()) {
    CaseSchema row{.word = std::string(law.name), .documentation = std::string(law.formula)};
    row.keys = parameter_keys(law);
    if (!law.terms.empty()) {
      MappingSchema term{.name = row.word + " term", .documentation = "A term of the sum."};
      term.keys = std::move(row.keys);
      row.keys = {{std::string(law.terms), list_value(mapping_value({term}), 1), true, {}, "terms of the sum"}};
    }
    words.push_back(row.word);
    material.cases.push_back(std::move(row));
  }
  material.keys = {{"law", word_value(words), true, {}, "law of the wall's strain energy"}};
  return mapping_value({material});
}

}  // namespace thinwall
