#include "renderer/annotation/ClearPlace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thinwall {
namespace {

constexpr double kSamePlace = 1e-9;  // pixels, by which plates that touch may overlap
constexpr double kAcross = 3;        // cost of a pixel across, of one up or down

bool is_clear(const Box& place, const std::vector<Box>& plates, double gap) {
  return std::ranges::none_of(plates, [&](const Box& plate) {
    return place.x + kSamePlace < plate.right() + gap && plate.x + kSamePlace < place.right() + gap &&
           place.y + kSamePlace < plate.bottom() + gap && plate.y + kSamePlace < place.bottom() + gap;
  });
}

bool is_inside(const Box& place, const Box& bounds) {
  return place.x >= bounds.x && place.right() <= bounds.right() && place.y >= bounds.y &&
         place.bottom() <= bounds.bottom();
}

}  // namespace

Box clear_place(const Box& box, const std::vector<Box>& plates, double gap, const Box& bounds) {
  if (is_clear(box, plates, gap)) return box;
  // The nearest clear place touches plates, or is where the box is, in each direction.
  std::vector<double> lefts = {box.x}, tops = {box.y};
  for (const Box& plate : plates) {
    lefts.insert(lefts.end(), {plate.x - gap - box.width, plate.right() + gap});
    tops.insert(tops.end(), {plate.bottom() + gap, plate.y - gap - box.height});
  }
  const double outside = kAcross * (bounds.width + bounds.height);
  Box nearest = box;
  double least = std::numeric_limits<double>::infinity();
  for (const double top : tops) {
    for (const double left : lefts) {
      const Box place{left, top, box.width, box.height};
      const double cost =
          kAcross * std::abs(left - box.x) + std::abs(top - box.y) + (is_inside(place, bounds) ? 0 : outside);
      if (cost < least && is_clear(place, plates, gap)) least = cost, nearest = place;
    }
  }
  return nearest;
}

}  // namespace thinwall
