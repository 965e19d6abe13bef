#include "renderer/wound/TriangleSplit.hpp"

#include <algorithm>
#include <span>

namespace thinwall {
namespace {

using Weights = std::array<double, 3>;
using Points = std::span<const std::uint32_t>;

struct Corner {
  std::uint32_t vertex = 0;
  Weights weights{};
};

struct Side {
  Corner from;
  std::vector<std::uint32_t> points;  // from there to the next side
};

Corner middle_of(const Side& side, const Corner& to) {
  Corner middle{.vertex = side.points[side.points.size() / 2], .weights = {}};
  for (std::size_t k = 0; k < 3; ++k) middle.weights[k] = 0.5 * (side.from.weights[k] + to.weights[k]);
  return middle;
}

std::vector<std::uint32_t> half_of(const Side& side, bool second) {
  const auto middle = side.points.begin() + static_cast<std::ptrdiff_t>(side.points.size() / 2);
  return second ? std::vector<std::uint32_t>(middle + 1, side.points.end())
                : std::vector<std::uint32_t>(side.points.begin(), middle);
}

void split(const std::array<Side, 3>& sides, std::vector<SplitTriangle>& pieces);

/// Along one edge: both halves reach to the corner across.
void split_in_two(const Side& a, const Side& b, const Side& c, std::vector<SplitTriangle>& pieces) {
  const Corner middle = middle_of(a, b.from);
  split({{{a.from, half_of(a, false)}, {middle, {}}, c}}, pieces);
  split({{{middle, half_of(a, true)}, b, {c.from, {}}}}, pieces);
}

/// Along the edges from `a` to `b` and from `b` to `c`.
void split_in_three(const Side& a, const Side& b, const Side& c, std::vector<SplitTriangle>& pieces) {
  const Corner first = middle_of(a, b.from), second = middle_of(b, c.from);
  split({{{first, half_of(a, true)}, {b.from, half_of(b, false)}, {second, {}}}}, pieces);
  split({{{a.from, half_of(a, false)}, {first, {}}, c}}, pieces);
  split({{{first, {}}, {second, half_of(b, true)}, {c.from, {}}}}, pieces);
}

void split_in_four(const std::array<Side, 3>& sides, std::vector<SplitTriangle>& pieces) {
  std::array<Corner, 3> middles;
  for (std::size_t k = 0; k < 3; ++k) middles[k] = middle_of(sides[k], sides[(k + 1) % 3].from);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t last = (k + 2) % 3;
    split({{{sides[k].from, half_of(sides[k], false)}, {middles[k], {}}, {middles[last], half_of(sides[last], true)}}},
          pieces);
  }
  split({{{middles[0], {}}, {middles[1], {}}, {middles[2], {}}}}, pieces);
}

void split(const std::array<Side, 3>& sides, std::vector<SplitTriangle>& pieces) {
  std::array<bool, 3> has{};
  for (std::size_t k = 0; k < 3; ++k) has[k] = !sides[k].points.empty();
  const auto count = std::ranges::count(has, true);
  if (count == 0) {
    SplitTriangle& piece = pieces.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      piece.vertices[k] = sides[k].from.vertex;
      piece.weights[k] = sides[k].from.weights;
    }
    return;
  }
  if (count == 3) return split_in_four(sides, pieces);
  // From the edge that begins what is to be cut.
  std::size_t first = 0;
  while (!has[first] || (count == 2 && !has[(first + 1) % 3])) ++first;
  const Side &a = sides[first], &b = sides[(first + 1) % 3], &c = sides[(first + 2) % 3];
  count == 1 ? split_in_two(a, b, c, pieces) : split_in_three(a, b, c, pieces);
}

}  // namespace

void split_triangle(const Triangle& triangle, const std::array<std::vector<std::uint32_t>, 3>& points,
                    std::vector<SplitTriangle>& pieces) {
  pieces.clear();
  std::array<Side, 3> sides;
  for (std::size_t k = 0; k < 3; ++k) {
    sides[k].from.vertex = triangle[k];
    sides[k].from.weights[k] = 1;
    sides[k].points = points[k];
  }
  split(sides, pieces);
}

}  // namespace thinwall
