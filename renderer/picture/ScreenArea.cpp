#include "renderer/picture/ScreenArea.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thinwall {
namespace {

/// Clip coordinates of a corner of the box; bit k of `which` chooses the end on axis k.
std::array<double, 4> clip_corner(const Bounds& box, unsigned which, const std::array<float, 16>& matrix) {
  std::array<double, 4> corner{0, 0, 0, 1};
  for (std::size_t axis = 0; axis < 3; ++axis) corner[axis] = (which >> axis & 1U) ? box.most[axis] : box.least[axis];
  std::array<double, 4> clip{};
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t column = 0; column < 4; ++column) clip[k] += matrix[4 * column + k] * corner[column];
  }
  return clip;
}

/// First and past-the-last pixel between two places from -1 to 1 of a side of `count` pixels, with the border.
std::array<int, 2> pixels_between(double least, double most, int count) {
  const auto pixel = [&](double place) { return std::clamp(0.5 * (place + 1), -1.0, 2.0) * count; };
  return {std::clamp(static_cast<int>(std::floor(pixel(least))) - 1, 0, count),
          std::clamp(static_cast<int>(std::ceil(pixel(most))) + 1, 0, count)};
}

}  // namespace

Bounds bounds_of(std::span<const SurfaceVertex> vertices) {
  Bounds bounds{vertices.front().position, vertices.front().position};
  for (const SurfaceVertex& vertex : vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds.least[axis] = std::min(bounds.least[axis], vertex.position[axis]);
      bounds.most[axis] = std::max(bounds.most[axis], vertex.position[axis]);
    }
  }
  return bounds;
}

Bounds around(const Bounds& a, const Bounds& b) {
  Bounds bounds;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bounds.least[axis] = std::min(a.least[axis], b.least[axis]);
    bounds.most[axis] = std::max(a.most[axis], b.most[axis]);
  }
  return bounds;
}

bool lies_ahead(const Bounds& box, const std::array<float, 16>& view_projection) {
  for (unsigned which = 0; which < 8; ++which) {
    const std::array<double, 4> clip = clip_corner(box, which, view_projection);
    if (!(clip[2] > -clip[3])) return false;
  }
  return true;
}

ScreenArea screen_area(const Bounds& box, const std::array<float, 16>& view_projection, ImageSize size) {
  constexpr double kFar = std::numeric_limits<double>::max();
  std::array<double, 2> least{kFar, kFar}, most{-kFar, -kFar};
  for (unsigned which = 0; which < 8; ++which) {
    const std::array<double, 4> clip = clip_corner(box, which, view_projection);
    if (!(clip[3] > 1e-6)) return {0, 0, size.width, size.height};
    for (std::size_t k = 0; k < 2; ++k) {
      least[k] = std::min(least[k], clip[k] / clip[3]);
      most[k] = std::max(most[k], clip[k] / clip[3]);
    }
  }
  const auto [left, right] = pixels_between(least[0], most[0], size.width);
  const auto [bottom, top] = pixels_between(least[1], most[1], size.height);
  return {left, bottom, right - left, top - bottom};
}

}  // namespace thinwall
