#include "renderer/annotation/LabelOrder.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace thinwall {
namespace {

/// Twice the area of a triangle, its sign that of the turn from a over b to c.
double turn(PixelPoint a, PixelPoint b, PixelPoint c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool cross_each_other(const Leader& a, const Leader& b) {
  return turn(a.from, a.to, b.from) * turn(a.from, a.to, b.to) <= 0 &&
         turn(b.from, b.to, a.from) * turn(b.from, b.to, a.to) <= 0;
}

std::vector<LabelWish> ordered(const std::vector<LabelWish>& wishes, const std::vector<std::size_t>& order) {
  std::vector<LabelWish> result;
  for (const std::size_t i : order) result.push_back(wishes[i]);
  return result;
}

LabelRoom room_beside_walls(const LabelMoment& moment, LabelRoom room) {
  room.tools.clear();
  room.obstacles = moment.outline;
  std::tie(room.walls_top, room.walls_bottom) = heights_of(moment.outline);
  return room;
}

/// Over all moments: by each other, as where they cross, and by labels.
int hidden_leaders_of(const std::vector<LabelMoment>& moments, const std::vector<std::size_t>& order,
                      const LabelRoom& bare_room) {
  int hidden = 0;
  for (const LabelMoment& moment : moments) {
    const std::vector<LabelWish> wishes = ordered(moment.wishes, order);
    LabelRoom room = room_beside_walls(moment, bare_room);
    for (const LabelWish& wish : wishes) room.obstacles.push_back(wish.anchor);
    const std::vector<Box> boxes = lay_out_labels(wishes, room);
    hidden += count_crossings(wishes, boxes) + count_leaders_under_labels(wishes, boxes);
  }
  return hidden;
}

void set_place(std::vector<LabelMoment>& moments, std::size_t label, LabelPlace place) {
  for (LabelMoment& moment : moments) moment.wishes[label].place = place;
}

bool has_room_always(const std::vector<LabelMoment>& moments, std::size_t label, const LabelRoom& room,
                     LabelPlace place) {
  return std::ranges::all_of(moments, [&](const LabelMoment& moment) {
    return has_room(moment.wishes[label], room_beside_walls(moment, room), place);
  });
}

/// The order in which a label has the turn of the one with which fewest leaders are hidden; its own where none has
/// fewer.
std::vector<std::size_t> best_turn_of(std::size_t label, const std::vector<std::size_t>& order,
                                      const std::vector<LabelMoment>& moments, const LabelRoom& room) {
  std::vector<std::size_t> best = order;
  int fewest = hidden_leaders_of(moments, order, room);
  for (std::size_t turn = 0; turn < order.size(); ++turn) {
    std::vector<std::size_t> other = order;
    std::swap(*std::ranges::find(other, label), other[turn]);
    const int now = hidden_leaders_of(moments, other, room);
    if (now < fewest) {
      fewest = now;
      best = std::move(other);
    }
  }
  return best;
}

}  // namespace

Leader leader_of(const LabelWish& wish, const Box& box) {
  const double edge = wish.on_the_left ? box.right() : box.x;
  const double over = std::max(0.0, wish.on_the_left ? edge - wish.anchor[0] : wish.anchor[0] - edge);
  const double x = over > 0 ? std::clamp(wish.anchor[0], box.x, box.right()) : edge;
  const double middle = box.y + 0.5 * box.height;
  const double off_middle = std::min(over, 0.5 * box.height);
  return {.from = {x, wish.anchor[1] > middle ? middle + off_middle : middle - off_middle}, .to = wish.anchor};
}

bool runs_through(const Leader& leader, const Box& box) {
  const auto holds = [&](PixelPoint point) {
    return point[0] >= box.x && point[0] <= box.right() && point[1] >= box.y && point[1] <= box.bottom();
  };
  // What enters and leaves it parts its corners, and so crosses a diagonal.
  return holds(leader.from) || holds(leader.to) ||
         cross_each_other(leader, {{box.x, box.y}, {box.right(), box.bottom()}}) ||
         cross_each_other(leader, {{box.x, box.bottom()}, {box.right(), box.y}});
}

int count_crossings(const std::vector<LabelWish>& wishes, const std::vector<Box>& boxes) {
  int crossings = 0;
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (cross_each_other(leader_of(wishes[i], boxes[i]), leader_of(wishes[k], boxes[k]))) ++crossings;
    }
  }
  return crossings;
}

int count_leaders_under_labels(const std::vector<LabelWish>& wishes, const std::vector<Box>& boxes) {
  int count = 0;
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    const Leader leader = leader_of(wishes[i], boxes[i]);
    for (std::size_t k = 0; k < boxes.size(); ++k) count += k != i && runs_through(leader, boxes[k]);
  }
  return count;
}

std::pair<double, double> heights_of(const std::vector<PixelPoint>& points) {
  if (points.empty()) return {0, 0};
  const auto [top, bottom] = std::ranges::minmax(points, {}, [](const PixelPoint& point) { return point[1]; });
  return {top[1], bottom[1]};
}

std::vector<PixelPoint> outline_of(const std::vector<PixelPoint>& points, double height) {
  std::map<double, std::pair<PixelPoint, PixelPoint>> rows;
  for (const PixelPoint& point : points) {
    auto& [left, right] = rows.try_emplace(std::floor(point[1] / height), point, point).first->second;
    if (point[0] < left[0]) left = point;
    if (point[0] > right[0]) right = point;
  }
  std::vector<PixelPoint> outline;
  for (const auto& [row, ends] : rows) outline.insert(outline.end(), {ends.first, ends.second});
  return outline;
}

std::vector<std::size_t> order_of_labels(const std::vector<LabelMoment>& moments, const LabelRoom& room) {
  if (moments.empty()) return {};
  std::vector<std::size_t> order(moments.front().wishes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::vector<double> heights(order.size(), 0);
  for (const LabelMoment& moment : moments) {
    for (std::size_t i = 0; i < order.size(); ++i) heights[i] += moment.wishes[i].anchor[1];
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return heights[i]; });
  int fewest = hidden_leaders_of(moments, order, room);
  // Each swap that stays leaves fewer hidden, so this ends.
  for (bool changes = fewest > 0; changes;) {
    changes = false;
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t k = i + 1; k < order.size(); ++k) {
        std::swap(order[i], order[k]);
        const int now = hidden_leaders_of(moments, order, room);
        if (now < fewest) {
          fewest = now;
          changes = true;
        } else {
          std::swap(order[i], order[k]);
        }
      }
    }
  }
  return order;
}

LabelArrangement arrange_labels(std::vector<LabelMoment> moments, const LabelRoom& room) {
  if (moments.empty()) return {};
  std::vector<std::size_t> order = order_of_labels(moments, room);
  int fewest = hidden_leaders_of(moments, order, room);
  for (std::size_t label = 0; label < order.size() && fewest > 0; ++label) {
    for (const LabelPlace place : {LabelPlace::kBeside, LabelPlace::kAbove, LabelPlace::kBelow}) {
      const LabelPlace kept = moments.front().wishes[label].place;
      if (place == kept || !has_room_always(moments, label, room, place)) continue;
      set_place(moments, label, place);
      std::vector<std::size_t> best = best_turn_of(label, order, moments, room);
      const int now = hidden_leaders_of(moments, best, room);
      if (now < fewest) {
        fewest = now;
        order = std::move(best);
      } else {
        set_place(moments, label, kept);
      }
    }
  }
  LabelArrangement arrangement{.order = std::move(order)};
  for (const LabelWish& wish : moments.front().wishes) arrangement.places.push_back(wish.place);
  return arrangement;
}

}  // namespace thinwall
