#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "studio/schema/Schema.hpp"

namespace thinwall {

/// The schema of a resolved scenario as a whole.
ValueSchema schema_of_scenario();

/// The schema of what stands under `key` in `json`, a mapping of a resolved scenario that follows `schema`; none where
/// the format has no such key.
std::optional<ValueSchema> schema_below(const ValueSchema& schema, const nlohmann::json& json, const std::string& key);

/// The schema of an item of a list that follows `schema`; none where the format has no such item.
std::optional<ValueSchema> schema_of_item(const ValueSchema& schema, std::size_t index);

/// A value of a resolved scenario as a scenario has it: quantities in the unit of the schema's example, lists and
/// mappings on one line: "[0 mm, 0 mm, 20 mm]", "{at: 100 ms, for: 2 s}". Numbers have six digits. Without a schema a
/// number is as it is resolved, in SI units.
std::string written_value(const nlohmann::json& value, const std::optional<ValueSchema>& schema);

}  // namespace thinwall
