#include "renderer/picture/SeenLining.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace thinwall {
namespace {

/// Places on the screen, -1 to 1 on both axes.
struct Rectangle {
  static constexpr float kFar = std::numeric_limits<float>::max();
  std::array<float, 2> least{kFar, kFar}, most{-kFar, -kFar};

  void add(const std::array<float, 2>& place) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      least[axis] = std::min(least[axis], place[axis]);
      most[axis] = std::max(most[axis], place[axis]);
    }
  }
  bool meets(const Rectangle& other) const {
    return least[0] <= other.most[0] && other.least[0] <= most[0] && least[1] <= other.most[1] &&
           other.least[1] <= most[1];
  }
};

/// None for what lies behind the eye.
std::optional<std::array<float, 2>> on_screen(const Float3& place, const std::array<float, 16>& matrix) {
  std::array<float, 4> clip;
  for (std::size_t row = 0; row < 4; ++row) {
    clip[row] = matrix[row] * place[0] + matrix[4 + row] * place[1] + matrix[8 + row] * place[2] + matrix[12 + row];
  }
  if (!(clip[3] > 0)) return std::nullopt;
  return std::array<float, 2>{clip[0] / clip[3], clip[1] / clip[3]};
}

std::optional<Rectangle> rectangle_of(const Bounds& box, const std::array<float, 16>& matrix) {
  Rectangle rectangle;
  for (unsigned which = 0; which < 8; ++which) {
    Float3 corner;
    for (std::size_t axis = 0; axis < 3; ++axis) corner[axis] = (which >> axis & 1U) ? box.most[axis] : box.least[axis];
    const auto place = on_screen(corner, matrix);
    if (!place) return std::nullopt;
    rectangle.add(*place);
  }
  return rectangle;
}

}  // namespace

std::vector<std::uint32_t> seen_lining(std::span<const SurfaceVertex> vertices, std::span<const std::uint32_t> corners,
                                       const Bounds& opening, const std::array<float, 16>& matrix) {
  std::vector<std::uint32_t> seen(corners.begin(), corners.end());
  const std::optional<Rectangle> window = rectangle_of(opening, matrix);
  if (!window) return seen;
  seen.clear();
  for (std::size_t first = 0; first + 2 < corners.size(); first += 3) {
    Rectangle rectangle;
    bool is_ahead = true;
    for (const std::uint32_t corner : corners.subspan(first, 3)) {
      const auto place = on_screen(vertices[corner].position, matrix);
      is_ahead = is_ahead && place;
      if (place) rectangle.add(*place);
    }
    if (is_ahead && !rectangle.meets(*window)) continue;
    seen.insert(seen.end(), corners.begin() + static_cast<std::ptrdiff_t>(first),
                corners.begin() + static_cast<std::ptrdiff_t>(first + 3));
  }
  return seen;
}

}  // namespace thinwall
