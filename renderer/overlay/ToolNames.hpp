#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "renderer/overlay/Text.hpp"

namespace thinwall {

/// The name of a tool beside a dash in its colour.
struct ToolName {
  std::size_t number = 0;  // of its colour
  Text text;
  int row = 0;      // 0: that of the heading
  double left = 0;  // pixels, of the text; the dash stands before it
};

/// Where names of tools may stand. Pixels.
struct ToolNameRoom {
  double heading = 0;  // where the first row begins
  double left = 0;     // where the rows below it begin
  double right = 0;    // where all end
  double dash = 0;     // length
  double space = 0;    // between dash and text
  double gap = 0;      // between one name and the next dash
};

/// Rows below the heading at most.
inline constexpr int kMostNameRows = 2;

/// Right of the heading, as far right as they can; where that has no room for all of them, in one row below it or in
/// two. Only where these do not hold them either names are cut, each to its share of the width, and left out where that
/// is too narrow for letters. `tools`: their numbers and names, in the order of which they stand.
std::vector<ToolName> place_tool_names(const std::vector<std::pair<std::size_t, std::string>>& tools,
                                       const TextStyle& style, const ToolNameRoom& room);

}  // namespace thinwall
