#pragma once

#include <optional>

namespace thinwall {

/// What stands under a key of a resolved scenario (an nlohmann::json), none where the key is absent. Throws
/// nlohmann::json::exception when it is of another type.
template <typename Value, typename Json>
std::optional<Value> find_resolved(const Json& mapping, const char* key) {
  if (!mapping.contains(key)) return std::nullopt;
  return mapping.at(key).template get<Value>();
}

}  // namespace thinwall
