#include "studio/schema/Schema.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

std::string list_expectation(const ValueSchema& value) {
  std::string text = "a list";
  if (value.minimum_items == value.maximum_items) {
    text += " of " + std::to_string(value.minimum_items);
  } else if (value.maximum_items != std::numeric_limits<std::size_t>::max()) {
    text += " of " + std::to_string(value.minimum_items) + " to " + std::to_string(value.maximum_items);
  } else if (value.minimum_items > 0) {
    text += " of at least " + std::to_string(value.minimum_items);
  }
  if (!value.example.empty()) text += " (e.g. " + value.example + ")";
  return text;
}

std::string quantity_expectation(const ValueSchema& value) {
  return dimension_name(value.dimension) + " (e.g. " + value.example + ")";
}

/// More words than a message should hold are in a table of the reference page.
constexpr std::size_t kMostWordsOfAMessage = 20;

std::string word_expectation(const ValueSchema& value) {
  if (value.words.size() > kMostWordsOfAMessage) {
    return "one of " + std::to_string(value.words.size()) + " words (e.g. " + value.words[1] + ")";
  }
  return (value.words.size() > 1 ? "one of " : "") + list_in_backticks(value.words);
}

std::string mapping_expectation(const ValueSchema& value) {
  if (value.mappings.size() < 2) return "a mapping";
  std::string text;
  for (const MappingSchema& mapping : value.mappings)
    text += (text.empty() ? "" : ", ") + in_backticks(mapping.keys[0].key);
  return "a mapping with one of " + text;
}

}  // namespace

const KeySchema* find_key(const std::vector<KeySchema>& keys, std::string_view key) {
  const auto found = std::ranges::find_if(keys, [&](const KeySchema& schema) { return schema.key == key; });
  return found == keys.end() ? nullptr : &*found;
}

const CaseSchema* find_case(const MappingSchema& mapping, std::string_view word) {
  const auto found = std::ranges::find_if(mapping.cases, [&](const CaseSchema& schema) { return schema.word == word; });
  return found == mapping.cases.end() ? nullptr : &*found;
}

std::string range_text(const Range& range, const std::string& example) {
  const bool has_minimum = std::isfinite(range.minimum);
  const bool has_maximum = std::isfinite(range.maximum);
  const std::string minimum = has_minimum ? format_like(range.minimum, example) : "";
  const std::string maximum = has_maximum ? format_like(range.maximum, example) : "";
  if (has_minimum && has_maximum && range.minimum == range.maximum) return minimum;
  if (has_minimum && has_maximum && !range.minimum_excluded && !range.maximum_excluded) {
    return "from " + minimum + " to " + maximum;
  }
  const std::string above = has_minimum ? (range.minimum_excluded ? "greater than " : "at least ") + minimum : "";
  const std::string below = has_maximum ? (range.maximum_excluded ? "less than " : "at most ") + maximum : "";
  return above + (has_minimum && has_maximum ? " and " : "") + below;
}

const ValueSchema& item_of(const ValueSchema& list, std::size_t index) {
  return list.item[list.item.size() == 1 ? 0 : index];
}

std::string expectation(const ValueSchema& value) {
  switch (value.kind) {
    case ValueKind::kText:
      return "a text";
    case ValueKind::kPath:
      return "the path of a file";
    case ValueKind::kWord:
      return word_expectation(value);
    case ValueKind::kName:
      return "a name";
    case ValueKind::kBoolean:
      return "`true` or `false`";
    case ValueKind::kInteger:
      return "a whole number (e.g. " + value.example + ")";
    case ValueKind::kQuantity:
      return quantity_expectation(value);
    case ValueKind::kAnyQuantity:
      return "a quantity (e.g. " + value.example + ")";
    case ValueKind::kDirection:
      return "a direction: three numbers, not all zero (e.g. [0, 0, -1])";
    case ValueKind::kAxes:
      return "some of the axes x, y, z (e.g. xyz or xz)";
    case ValueKind::kList:
      return list_expectation(value);
    case ValueKind::kMapping:
    case ValueKind::kNamedMappings:
    case ValueKind::kParameters:
    case ValueKind::kChanges:
      return mapping_expectation(value);
  }
  return "";
}

}  // namespace thinwall
