#include "renderer/overlay/ToolNames.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace thinwall {
namespace {

constexpr ToolNameRoom kRoom{.heading = 70, .left = 15, .right = 237, .dash = 12, .space = 5, .gap = 12};
const TextStyle kStyle{.size = 13.5};

using Names = std::vector<std::string>;

std::vector<ToolName> placed(const Names& names) {
  std::vector<std::pair<std::size_t, std::string>> tools;
  for (const std::string& name : names) tools.emplace_back(tools.size(), name);
  return place_tool_names(tools, kStyle, kRoom);
}

std::vector<int> rows_of(const std::vector<ToolName>& names) {
  std::vector<int> rows;
  for (const ToolName& name : names) rows.push_back(name.row);
  return rows;
}

/// Each with its dash within its row and behind the one before.
void expect_apart(const std::vector<ToolName>& names) {
  int row = 0;
  double free = kRoom.heading;
  for (const ToolName& name : names) {
    if (name.row > row) free = kRoom.left;
    row = name.row;
    EXPECT_GE(name.left - kRoom.space - kRoom.dash, free - 1e-6);
    EXPECT_LE(name.left + name.text.width(), kRoom.right + 1e-6);
    free = name.left + name.text.width() + kRoom.gap;
  }
}

bool any_is_cut(const std::vector<ToolName>& names) {
  return std::ranges::any_of(names, [](const ToolName& name) { return name.text.is_cut(); });
}

TEST(ToolNames, StandWholeBesideTheHeadingOrInRowsBelowIt) {
  struct Case {
    Names names;
    std::vector<int> rows;
  };
  for (const auto& [names, rows] :
       {Case{{"probe", "needle"}, {0, 0}}, Case{{"blade", "board", "ball"}, {1, 1, 1}},
        Case{{"blunt_dissector", "needle"}, {1, 1}}, Case{{"left_forceps", "right_forceps", "scalpel"}, {1, 1, 2}}}) {
    SCOPED_TRACE(names.back());
    const std::vector<ToolName> placed_names = placed(names);
    EXPECT_EQ(rows_of(placed_names), rows);
    EXPECT_FALSE(any_is_cut(placed_names));
    expect_apart(placed_names);
  }
}

TEST(ToolNames, AreCutToTheirSharesWhereTwoRowsDoNotHoldThem) {
  const Names names = {"first_pair_of_forceps", "second_pair_of_forceps", "scalpel_of_the_assistant", "probe"};
  const std::vector<ToolName> placed_names = placed(names);
  EXPECT_EQ(rows_of(placed_names), (std::vector<int>{1, 1, 2, 2}));
  EXPECT_TRUE(placed_names[0].text.is_cut());
  EXPECT_FALSE(placed_names[3].text.is_cut());
  expect_apart(placed_names);
  EXPECT_TRUE(placed(Names(40, "needle")).empty());
}

}  // namespace
}  // namespace thinwall
