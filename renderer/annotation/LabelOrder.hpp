#pragma once

#include <cstddef>
#include <vector>

#include "renderer/annotation/LabelLayout.hpp"

namespace thinwall {

/// The straight line from a label's box to what it points at.
struct Leader {
  PixelPoint from = {};
  PixelPoint to = {};
};
Leader leader_of(const LabelWish& wish, const Box& box);

/// How many pairs of leaders cross or touch.
int count_crossings(const std::vector<LabelWish>& wishes, const std::vector<Box>& boxes);

/// The order, from above, in which labels are laid out so that over `moments` (the wishes of the same labels at some
/// times) as few leaders cross as swaps of two can reach; without need that of their mean heights. It holds for
/// all moments, so that labels do not change places while they are shown. `room`: its bounds count, not its obstacles.
std::vector<std::size_t> order_of_labels(const std::vector<std::vector<LabelWish>>& moments, const LabelRoom& room);

}  // namespace thinwall
