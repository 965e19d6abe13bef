#include "renderer/look/Ground.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {

const Ground* find_ground(std::string_view word) {
  const auto* row = std::ranges::find(kGrounds, word, &std::pair<std::string_view, Ground>::first);
  return row == kGrounds.end() ? nullptr : &row->second;
}

bool lies_below(const Double3& gravity) {
  const auto& [x, y, z] = gravity;
  return z <= -std::hypot(x, y);
}

}  // namespace thinwall
