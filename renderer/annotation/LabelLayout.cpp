#include "renderer/annotation/LabelLayout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace thinwall {
namespace {

/// Labels that stand one below the other without a gap to spare.
struct Stack {
  std::size_t count = 0;
  double wanted = 0;  // sum over its labels of where each would have the stack begin
  double height = 0;  // with a gap below each
  double top() const { return wanted / static_cast<double>(count); }
};

/// Tops that keep the order, do not overlap, and are nearest to the wanted ones: neighbours that overlap are joined
/// until none do (pool adjacent violators).
std::vector<double> spread(const std::vector<double>& wanted, const std::vector<double>& heights) {
  std::vector<Stack> stacks;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    stacks.push_back({.count = 1, .wanted = wanted[i], .height = heights[i]});
    while (stacks.size() > 1 &&
           stacks[stacks.size() - 2].top() + stacks[stacks.size() - 2].height > stacks.back().top()) {
      const Stack lower = stacks.back();
      stacks.pop_back();
      Stack& upper = stacks.back();
      upper.wanted += lower.wanted - static_cast<double>(lower.count) * upper.height;
      upper.count += lower.count;
      upper.height += lower.height;
    }
  }
  std::vector<double> tops;
  for (const Stack& stack : stacks) {
    double top = stack.top();
    for (std::size_t i = 0; i < stack.count; ++i) {
      tops.push_back(top);
      top += heights[tops.size() - 1];
    }
  }
  return tops;
}

/// Pushes labels down from the upper bound and up from the lower one; when there are too many the upper bound counts.
void keep_inside(std::vector<double>& tops, const std::vector<double>& heights, double gap, const Box& bounds) {
  double lowest = bounds.bottom() + gap;
  for (std::size_t i = tops.size(); i-- > 0;) {
    tops[i] = std::min(tops[i], lowest - heights[i]);
    lowest = tops[i];
  }
  double highest = bounds.y;
  for (std::size_t i = 0; i < tops.size(); ++i) {
    tops[i] = std::max(tops[i], highest);
    highest = tops[i] + heights[i];
  }
}

/// The x beyond which obstacles keep a label of the given span of heights. Obstacles above and below count less the
/// farther they are, so that the result changes steadily.
double free_edge(const LabelWish& wish, const LabelRoom& room, double top) {
  const double sign = wish.on_the_left ? 1 : -1;
  // Never on the wrong side of its anchor, also where nothing stands in the way.
  double edge = sign * wish.anchor[0];
  for (const PixelPoint& obstacle : wish.place == LabelPlace::kBeside ? room.obstacles : room.tools) {
    const double off = std::max({0.0, top - room.gap - obstacle[1], obstacle[1] - top - wish.height - room.gap});
    edge = std::min(edge, sign * obstacle[0] + 2 * off);
  }
  return sign * edge;
}

bool is_on_the_left(const Box& taken, const Box& bounds) {
  return taken.x + taken.right() < bounds.x + bounds.right();
}

/// As a legend, unlike a picture.
bool is_high(const Box& taken) {
  return taken.height > taken.width;
}

/// Whether labels of a side, at most this wide, find no place beside what is taken.
bool is_side_taken(const Box& taken, const LabelRoom& room, bool on_the_left, double widest) {
  const bool is_left = is_on_the_left(taken, room.bounds);
  if (!is_high(taken) && is_left == on_the_left) return true;
  const double beside = is_left ? room.bounds.right() - taken.right() : taken.x - room.bounds.x;
  return beside < widest + room.gap;
}

/// The bounds above or below what is taken, whichever are higher.
Box free_heights(Box bounds, const Box& taken, double gap) {
  const double above = taken.y - gap - bounds.y;
  const double below = bounds.bottom() - taken.bottom() - gap;
  if (below >= above) bounds.y = bounds.bottom() - std::max(0.0, below);
  bounds.height = std::max({0.0, above, below});
  return bounds;
}

/// Beside what is taken, when the label stands at its height or on the other side of the bounds. What is high yields
/// steadily above and below, as obstacles do, since labels pass its ends.
double beside_taken(const LabelWish& wish, const Box& taken, const LabelRoom& room, double left, double top) {
  const bool is_left = is_on_the_left(taken, room.bounds);
  double yielded = 0;
  if (is_left == wish.on_the_left) {
    const double off = std::max({0.0, top - room.gap - taken.bottom(), taken.y - room.gap - top - wish.height});
    const bool is_level = top < taken.bottom() + room.gap && top + wish.height + room.gap > taken.y;
    if (!is_level && !is_high(taken)) return left;
    yielded = 2 * off;
  }
  return is_left ? std::max(left, taken.right() + room.gap - yielded)
                 : std::min(left, taken.x - room.gap - wish.width + yielded);
}

double left_of(const LabelWish& wish, const LabelRoom& room, double top) {
  const double edge = free_edge(wish, room, top);
  double left = wish.on_the_left ? edge - room.distance - wish.width : edge + room.distance;
  for (const Box& taken : room.taken) left = beside_taken(wish, taken, room, left, top);
  return std::max(room.bounds.x, std::min(left, room.bounds.right() - wish.width));
}

/// How far the bounds press a label that is level with its anchor over that: from 0, where a gap is between them, to 1.
double pressed_part(const LabelWish& wish, const LabelRoom& room) {
  if (wish.place != LabelPlace::kBeside) return 0;
  const double left = left_of(wish, room, wish.anchor[1] - 0.5 * wish.height);
  const double between = wish.on_the_left ? wish.anchor[0] - left - wish.width : left - wish.anchor[0];
  return std::clamp(1 - between / room.gap, 0.0, 1.0);
}

/// Level with its anchor; where the bounds press it over the anchor, above or below, on its way there from a gap
/// before.
double wanted_top(const LabelWish& wish, const LabelRoom& room) {
  const double way = pressed_part(wish, room) * 0.5 * (wish.height + room.distance);
  return wish.anchor[1] - 0.5 * wish.height + (wish.upwards ? -way : way);
}

/// How far a label stays above or below an anchor that it is pressed over.
double clearance(const LabelRoom& room) {
  return 0.25 * room.distance;
}

/// Pushes pressed labels that stand below their anchors down, and those that stand above up, so far that others of
/// their stack do not bring them back over their anchors.
void clear_anchors(std::vector<double>& tops, const std::vector<double>& heights, const std::vector<LabelWish>& wishes,
                   const LabelRoom& room) {
  const auto yielded = [&](const LabelWish& wish, double part) {
    return (1 - part) * (wish.height + 2 * clearance(room));
  };
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = tops.size(); i-- > 0;) {
    const double part = wishes[i].upwards ? pressed_part(wishes[i], room) : 0;
    const double clear = wishes[i].anchor[1] - clearance(room) - wishes[i].height;
    if (part > 0) tops[i] = std::min(tops[i], clear + yielded(wishes[i], part));
    tops[i] = std::min(tops[i], lowest - heights[i]);
    lowest = tops[i];
  }
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < tops.size(); ++i) {
    const double part = wishes[i].upwards ? 0 : pressed_part(wishes[i], room);
    const double clear = wishes[i].anchor[1] + clearance(room);
    if (part > 0) tops[i] = std::max(tops[i], clear - yielded(wishes[i], part));
    tops[i] = std::max(tops[i], highest);
    highest = tops[i] + heights[i];
  }
}

/// Those above and below the walls one by one away from them.
std::vector<double> wanted_tops(const std::vector<LabelWish>& wishes, const LabelRoom& room) {
  std::vector<double> tops;
  double lower = room.walls_bottom + room.distance, upper = room.walls_top - room.distance + room.gap;
  for (const LabelWish& wish : wishes) {
    tops.push_back(wish.place == LabelPlace::kBelow ? lower : wanted_top(wish, room));
    if (wish.place == LabelPlace::kBelow) lower += wish.height + room.gap;
  }
  for (std::size_t i = wishes.size(); i-- > 0;) {
    if (wishes[i].place == LabelPlace::kAbove) tops[i] = upper -= wishes[i].height + room.gap;
  }
  return tops;
}

/// The heights that what is taken leaves to the labels of a side.
Box bounds_of_side(const std::vector<LabelWish>& side, const LabelRoom& room) {
  double widest = 0;
  for (const LabelWish& wish : side) widest = std::max(widest, wish.width);
  Box bounds = room.bounds;
  for (const Box& taken : room.taken) {
    if (is_side_taken(taken, room, side.front().on_the_left, widest)) bounds = free_heights(bounds, taken, room.gap);
  }
  return bounds;
}

std::vector<Box> lay_out_side(const std::vector<LabelWish>& side, const LabelRoom& room) {
  std::vector<double> heights;
  for (const LabelWish& wish : side) heights.push_back(wish.height + room.gap);
  std::vector<double> tops = spread(wanted_tops(side, room), heights);
  clear_anchors(tops, heights, side, room);
  keep_inside(tops, heights, room.gap, bounds_of_side(side, room));
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < side.size(); ++i) {
    boxes.push_back({left_of(side[i], room, tops[i]), tops[i], side[i].width, side[i].height});
  }
  return boxes;
}

bool covers(const Box& box, PixelPoint anchor, double margin) {
  return anchor[0] > box.x - margin && anchor[0] < box.right() + margin && anchor[1] > box.y - margin &&
         anchor[1] < box.bottom() + margin;
}

/// Anchors of the side under its labels, pairs.
int count_covered(const std::vector<LabelWish>& side, const std::vector<Box>& boxes, const LabelRoom& room) {
  int count = 0;
  for (const Box& box : boxes) {
    for (const LabelWish& wish : side) count += covers(box, wish.anchor, 0.5 * clearance(room));
  }
  return count;
}

/// Where a label covers its anchor all the same, as near a bound, it goes to the other side of that, up or down, when
/// fewer are covered then.
std::vector<Box> lay_out_clear_of_anchors(std::vector<LabelWish> side, const LabelRoom& room) {
  std::vector<Box> boxes = lay_out_side(side, room);
  int fewest = count_covered(side, boxes, room);
  for (std::size_t i = 0; i < side.size() && fewest > 0; ++i) {
    if (pressed_part(side[i], room) == 0) continue;
    side[i].upwards = !side[i].upwards;
    std::vector<Box> turned = lay_out_side(side, room);
    const int now = count_covered(side, turned, room);
    if (now < fewest) {
      fewest = now;
      boxes = std::move(turned);
    } else {
      side[i].upwards = !side[i].upwards;
    }
  }
  return boxes;
}

}  // namespace

std::vector<Box> lay_out_labels(const std::vector<LabelWish>& wishes, const LabelRoom& room) {
  std::vector<Box> boxes(wishes.size());
  for (const bool on_the_left : {true, false}) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < wishes.size(); ++i) {
      if (wishes[i].on_the_left == on_the_left) members.push_back(i);
    }
    if (members.empty()) continue;
    std::ranges::stable_sort(members, {}, [&](std::size_t i) { return wishes[i].place; });
    std::vector<LabelWish> side;
    for (const std::size_t i : members) side.push_back(wishes[i]);
    const std::vector<Box> laid_out = lay_out_clear_of_anchors(std::move(side), room);
    for (std::size_t k = 0; k < members.size(); ++k) boxes[members[k]] = laid_out[k];
  }
  return boxes;
}

bool has_room(const LabelWish& wish, const LabelRoom& room, LabelPlace place) {
  constexpr double kLongestWay = 0.5;  // of the bounds: from near, a line would cross what is shown
  if (place == LabelPlace::kBeside) {
    const double edge = free_edge(wish, room, wish.anchor[1] - 0.5 * wish.height);
    const double beside = wish.on_the_left ? edge - room.bounds.x : room.bounds.right() - edge;
    // The rim of an organ may be covered a little.
    return beside + room.distance >= wish.width + room.gap;
  }
  const bool is_above = place == LabelPlace::kAbove;
  const double free = is_above ? room.walls_top - room.bounds.y : room.bounds.bottom() - room.walls_bottom;
  const double way = is_above ? wish.anchor[1] - room.walls_top : room.walls_bottom - wish.anchor[1];
  return free - room.gap >= wish.height && way <= kLongestWay * room.bounds.height;
}

LabelPlace roomy_place(const LabelWish& wish, const LabelRoom& room) {
  if (has_room(wish, room, LabelPlace::kBeside)) return LabelPlace::kBeside;
  const bool fits_above = has_room(wish, room, LabelPlace::kAbove);
  const bool fits_below = has_room(wish, room, LabelPlace::kBelow);
  const double up = wish.anchor[1] - room.walls_top, down = room.walls_bottom - wish.anchor[1];
  if (fits_above && (up < down || !fits_below)) return LabelPlace::kAbove;
  return fits_below ? LabelPlace::kBelow : LabelPlace::kBeside;
}

}  // namespace thinwall
