#include "studio/scenario/ResolvedDefaults.hpp"

#include <nlohmann/json.hpp>

#include "studio/scenario/ResolvedScenario.hpp"
#include "studio/scenario/ResolvedSchema.hpp"
#include "studio/scenario/UnitPass.hpp"
#include "studio/schema/Schema.hpp"

namespace thinwall {
namespace {

using OrderedJson = nlohmann::ordered_json;

void fill(const ValueSchema& schema, OrderedJson& json);

OrderedJson default_of(const KeySchema& key) {
  Diagnostics none;
  const CheckedValue read = unit_pass({.kind = NodeKind::kMapping, .members = {}}, {.keys = {key}}, none);
  return OrderedJson::parse(resolved_scenario(read.at(key.key), {}));
}

void fill_keys(const std::vector<KeySchema>& keys, OrderedJson& json) {
  for (const KeySchema& key : keys) {
    if (json.contains(key.key)) {
      fill(key.value, json.at(key.key));
    } else if (key.fallback) {
      json[key.key] = default_of(key);
    }
  }
}

void fill_mapping(const MappingSchema& mapping, OrderedJson& json) {
  fill_keys(mapping.keys, json);
  const CaseSchema* chosen = case_of(mapping, json);
  if (chosen != nullptr) fill_keys(chosen->keys, json);
}

void fill(const ValueSchema& schema, OrderedJson& json) {
  if (json.is_array() && schema.kind == ValueKind::kList) {
    for (std::size_t i = 0; i < json.size(); ++i) fill(item_of(schema, i), json[i]);
  }
  if (!json.is_object() || schema.mappings.empty()) return;
  if (schema.kind == ValueKind::kNamedMappings) {
    for (auto& [name, value] : json.items()) {
      if (value.is_object()) fill_mapping(schema.mappings[0], value);
    }
    return;
  }
  const MappingSchema* mapping = mapping_of(schema, json);
  if (mapping != nullptr) fill_mapping(*mapping, json);
}

}  // namespace

std::string with_defaults(const std::string& resolved) {
  OrderedJson json = OrderedJson::parse(resolved, nullptr, false);
  if (!json.is_object()) return resolved;
  fill_mapping(scenario_schema(), json);
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace thinwall
