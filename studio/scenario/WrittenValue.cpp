#include "studio/scenario/WrittenValue.hpp"

#include <nlohmann/json.hpp>

#include "studio/scenario/ResolvedSchema.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::json;

std::string plain(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool is_a_word(ValueKind kind) {
  return kind == ValueKind::kWord || kind == ValueKind::kName || kind == ValueKind::kAxes;
}

std::string written_scalar(const Json& value, const ValueSchema& schema) {
  if (value.is_number() && schema.kind == ValueKind::kQuantity) {
    return format_like(value.get<double>(), schema.example);
  }
  if (value.is_string() && is_a_word(schema.kind)) return value.get<std::string>();
  return plain(value);
}

std::string written_list(const Json& list, const std::optional<ValueSchema>& schema) {
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i) {
    text += (i == 0 ? "" : ", ") + written_value(list[i], schema ? schema_of_item(*schema, i) : std::nullopt);
  }
  return "[" + text + "]";
}

std::string written_mapping(const Json& mapping, const std::optional<ValueSchema>& schema) {
  std::string text;
  for (const auto& [key, value] : mapping.items()) {
    const std::optional<ValueSchema> below = schema ? schema_below(*schema, mapping, key) : std::nullopt;
    text += (text.empty() ? "" : ", ") + key + ": " + written_value(value, below);
  }
  return "{" + text + "}";
}

}  // namespace

ValueSchema schema_of_scenario() {
  return {.kind = ValueKind::kMapping, .mappings = {scenario_schema()}};
}

std::optional<ValueSchema> schema_below(const ValueSchema& schema, const Json& json, const std::string& key) {
  if (schema.kind == ValueKind::kNamedMappings) {
    return ValueSchema{.kind = ValueKind::kMapping, .mappings = schema.mappings};
  }
  const MappingSchema* mapping = mapping_of(schema, json);
  if (mapping == nullptr) return std::nullopt;
  const CaseSchema* chosen = case_of(*mapping, json);
  const KeySchema* found = find_key(mapping->keys, key);
  if (found == nullptr && chosen != nullptr) found = find_key(chosen->keys, key);
  return found == nullptr ? std::nullopt : std::optional(found->value);
}

std::optional<ValueSchema> schema_of_item(const ValueSchema& schema, std::size_t index) {
  if (schema.kind != ValueKind::kList || schema.item.empty()) return std::nullopt;
  return schema.item.size() == 1 || index < schema.item.size() ? std::optional(item_of(schema, index)) : std::nullopt;
}

std::string written_value(const Json& value, const std::optional<ValueSchema>& schema) {
  if (value.is_array()) return written_list(value, schema);
  if (value.is_object()) return written_mapping(value, schema);
  return schema ? written_scalar(value, *schema) : plain(value);
}

}  // namespace thinwall
