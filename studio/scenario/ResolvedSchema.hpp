#pragma once

#include <algorithm>
#include <string>

#include "studio/schema/Schema.hpp"

namespace thinwall {

/// The mapping of a schema that `json`, a mapping of a resolved scenario, follows: of several forms the one whose first
/// key is there. Null when the schema has none for it.
template <typename Json>
const MappingSchema* mapping_of(const ValueSchema& schema, const Json& json) {
  const auto is_meant = [&](const MappingSchema& mapping) {
    return schema.mappings.size() == 1 || json.contains(mapping.keys[0].key);
  };
  const auto found = std::ranges::find_if(schema.mappings, is_meant);
  return found == schema.mappings.end() ? nullptr : &*found;
}

/// The case of a mapping that `json` has chosen, or null.
template <typename Json>
const CaseSchema* case_of(const MappingSchema& mapping, const Json& json) {
  if (mapping.selector.empty() || !json.contains(mapping.selector)) return nullptr;
  const Json& word = json.at(mapping.selector);
  return word.is_string() ? find_case(mapping, word.template get<std::string>()) : nullptr;
}

}  // namespace thinwall
