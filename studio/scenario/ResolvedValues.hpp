#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "renderer/image/PictureCorner.hpp"

namespace thinwall {

/// What stands under a key of a resolved scenario (an nlohmann::json), none where the key is absent. Throws
/// nlohmann::json::exception when it is of another type.
template <typename Value, typename Json>
std::optional<Value> find_resolved(const Json& mapping, const char* key) {
  if (!mapping.contains(key)) return std::nullopt;
  return mapping.at(key).template get<Value>();
}

/// Likewise of a corner's word.
template <typename Json>
std::optional<PictureCorner> find_corner(const Json& mapping, const char* key) {
  const auto word = find_resolved<std::string>(mapping, key);
  if (!word) return std::nullopt;
  return static_cast<PictureCorner>(std::ranges::find(kCornerWords, *word) - kCornerWords.begin());
}

}  // namespace thinwall
