#include "renderer/wound/FluidLevel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace thinwall {
namespace {

struct Corner {
  Vector3 place;
  double above = 0;  // the level, metres
};

Corner between(const Corner& a, const Corner& b) {
  const double part = a.above / (a.above - b.above);
  return {.place = a.place + part * (b.place - a.place), .above = 0};
}

std::array<Corner, 3> corners_of(std::span<const Float3> positions, const Triangle& triangle, Vector3 up,
                                 double level) {
  std::array<Corner, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 place = vector3(positions[triangle[k]]);
    corners[k] = {.place = place, .above = dot(place, up) - level};
  }
  return corners;
}

/// What a triangle adds to the integral over the part below the level.
double part_below(const std::array<Corner, 3>& corners, Vector3 up) {
  std::array<Corner, 4> below;
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner &a = corners[k], &b = corners[(k + 1) % 3];
    if (a.above <= 0) below[count++] = a;
    if ((a.above < 0 && b.above > 0) || (a.above > 0 && b.above < 0)) below[count++] = between(a, b);
  }
  double sum = 0;
  for (std::size_t k = 2; k < count; ++k) {
    const Vector3 area = 0.5 * cross(below[k - 1].place - below[0].place, below[k].place - below[0].place);
    sum += dot(area, up) * (below[0].above + below[k - 1].above + below[k].above) / 3;
  }
  return sum;
}

}  // namespace

Vector3 downward(const Snapshot& snapshot) {
  return normalized(vector3(snapshot.gravity), {0, 0, -1});
}

double volume_below(std::span<const Float3> positions, std::span<const Triangle> closed, Vector3 up, double level) {
  double volume = 0;
  for (const Triangle& triangle : closed) volume += part_below(corners_of(positions, triangle, up, level), up);
  return volume;
}

double fluid_level(std::span<const Float3> positions, std::span<const Triangle> closed, Vector3 up, double air) {
  if (!(air > 0) || closed.empty()) return kBrimful;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Triangle& triangle : closed) {
    for (const std::uint32_t vertex : triangle) {
      const double height = dot(vector3(positions[vertex]), up);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  const double fluid = volume_below(positions, closed, up, high) - air;
  if (fluid <= 0) return low;
  // Regula falsi after Illinois: an end that stays twice counts half.
  const double close = 1e-10 * (fluid + air);
  double low_miss = -fluid, high_miss = air;
  int last_side = 0;
  for (;;) {
    const double level = low + (high - low) * std::clamp(low_miss / (low_miss - high_miss), 0.001, 0.999);
    const double miss = volume_below(positions, closed, up, level) - fluid;
    const int side = miss < 0 ? -1 : 1;
    if (std::abs(miss) <= close || !(low < level && level < high)) return level;
    (side < 0 ? low : high) = level;
    (side < 0 ? low_miss : high_miss) = miss;
    if (side == last_side) (side < 0 ? high_miss : low_miss) *= 0.5;
    last_side = side;
  }
}

std::vector<Vector3> level_contour(std::span<const Float3> positions, std::span<const Triangle> closed, Vector3 up,
                                   double level) {
  std::vector<Vector3> contour;
  for (const Triangle& triangle : closed) {
    const std::array<Corner, 3> corners = corners_of(positions, triangle, up, level);
    Vector3 leaves, enters;
    int crossings = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &a = corners[k], &b = corners[(k + 1) % 3];
      const bool a_below = a.above < 0, b_below = b.above < 0;
      if (a_below == b_below) continue;
      (a_below ? leaves : enters) = between(a, b).place;
      ++crossings;
    }
    if (crossings == 2) contour.insert(contour.end(), {enters, leaves});
  }
  return contour;
}

}  // namespace thinwall
