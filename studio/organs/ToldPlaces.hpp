#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <string>
#include <vector>

namespace thinwall {

/// How many places or parts a message names before it only counts the rest.
inline constexpr std::size_t kToldAtMost = 3;

/// "(1, 2.5, 0)"
std::string place_text(const Eigen::Vector3d& place);

/// "A, B, C and 4 more, in mm": the first items as `describe` gives them, and the unit of their coordinates.
template <typename Item, typename Describe>
std::string told_places(const std::vector<Item>& items, const Describe& describe, const std::string& unit_name) {
  std::string text;
  for (std::size_t i = 0; i < std::min(items.size(), kToldAtMost); ++i) {
    text += (i == 0 ? "" : ", ") + describe(items[i]);
  }
  if (items.size() > kToldAtMost) text += " and " + std::to_string(items.size() - kToldAtMost) + " more";
  return text + ", in " + unit_name;
}

}  // namespace thinwall
