#include "renderer/look/Ground.hpp"

#include <algorithm>

namespace thinwall {

const Ground* find_ground(std::string_view word) {
  const auto* row = std::ranges::find(kGrounds, word, &std::pair<std::string_view, Ground>::first);
  return row == kGrounds.end() ? nullptr : &row->second;
}

}  // namespace thinwall
