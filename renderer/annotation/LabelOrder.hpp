#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "renderer/annotation/LabelLayout.hpp"

namespace thinwall {

/// The straight line from a label's box to what it points at: from the middle of the side that faces it; the farther
/// the box reaches over what it points at, the nearer to its lower or upper side.
struct Leader {
  PixelPoint from = {};
  PixelPoint to = {};
};
Leader leader_of(const LabelWish& wish, const Box& box);

/// Whether a leader runs through a box, touches it or ends in it.
bool runs_through(const Leader& leader, const Box& box);

/// How many pairs of leaders cross or touch.
int count_crossings(const std::vector<LabelWish>& wishes, const std::vector<Box>& boxes);

/// How often a leader runs through the box of another label, which covers it.
int count_leaders_under_labels(const std::vector<LabelWish>& wishes, const std::vector<Box>& boxes);

/// The same labels as at other moments, and what they stand beside then.
struct LabelMoment {
  std::vector<LabelWish> wishes = {};
  std::vector<PixelPoint> outline = {};  // of the organs
};

/// The leftmost and the rightmost of the points in each row, `height` pixels high: what labels beside them keep clear
/// of.
std::vector<PixelPoint> outline_of(const std::vector<PixelPoint>& points, double height);

/// Of the uppermost and of the lowest of the points; 0 where there are none.
std::pair<double, double> heights_of(const std::vector<PixelPoint>& points);

/// The order, from above, in which labels are laid out so that over `moments` as few leaders cross or run under other
/// labels as swaps of two can reach; without need that of their mean heights. It holds for all moments, so that labels
/// do not change places while they are shown. `room`: its bounds count, not its obstacles.
std::vector<std::size_t> order_of_labels(const std::vector<LabelMoment>& moments, const LabelRoom& room);

/// How labels are laid out, for all moments.
struct LabelArrangement {
  std::vector<std::size_t> order = {};  // from above, of the wishes
  std::vector<LabelPlace> places = {};  // of the wishes in their own order
};

/// In that order and where they wish; where leaders are hidden all the same, labels go to other places that have room
/// for them at all moments, each perhaps in the turn of another, as long as that leaves fewer hidden.
LabelArrangement arrange_labels(std::vector<LabelMoment> moments, const LabelRoom& room);

}  // namespace thinwall
