#include "renderer/overlay/ToolNames.hpp"

namespace thinwall {
namespace {

using Tools = std::vector<std::pair<std::size_t, std::string>>;

std::vector<ToolName> names_of(const Tools& tools, const TextStyle& style, const TextLimits& limits) {
  std::vector<ToolName> names;
  for (const auto& [number, tool] : tools) names.push_back({.number = number, .text = Text(tool, style, limits)});
  return names;
}

/// Returns whether the row of the heading holds them.
bool place_beside_heading(std::vector<ToolName>& names, const ToolNameRoom& room) {
  double right = room.right;
  for (std::size_t i = names.size(); i-- > 0;) {
    names[i].row = 0;
    names[i].left = right - names[i].text.width();
    right -= names[i].text.width() + room.space;
    right -= room.dash + room.gap;
  }
  return right + room.gap >= room.heading;
}

/// One after the other, in the next row where one has no room left. Returns whether `rows` hold them.
bool place_in_rows(std::vector<ToolName>& names, const ToolNameRoom& room, int rows) {
  constexpr double kRoundoff = 1e-6;
  const double mark = room.dash + room.space;
  double left = room.left;
  int row = 1;
  for (ToolName& name : names) {
    const double width = mark + name.text.width();
    if (left > room.left && left + width > room.right + kRoundoff) {
      left = room.left;
      ++row;
    }
    name.row = row;
    name.left = left + mark;
    if (row > rows || left + width > room.right + kRoundoff) return false;
    left += width + room.gap;
  }
  return true;
}

}  // namespace

std::vector<ToolName> place_tool_names(const Tools& tools, const TextStyle& style, const ToolNameRoom& room) {
  std::vector<ToolName> names = names_of(tools, style, {});
  if (place_beside_heading(names, room)) return names;
  for (int rows = 1; rows <= kMostNameRows; ++rows) {
    if (place_in_rows(names, room, rows)) return names;
  }
  const std::size_t in_a_row = (tools.size() + kMostNameRows - 1) / kMostNameRows;
  const double share = (room.right - room.left + room.gap) / static_cast<double>(in_a_row) - room.gap;
  const double width = share - room.dash - room.space;
  if (width < 0.6 * style.size) return {};
  names = names_of(tools, style, {.width = width, .lines = 1});
  place_in_rows(names, room, kMostNameRows);
  return names;
}

}  // namespace thinwall
