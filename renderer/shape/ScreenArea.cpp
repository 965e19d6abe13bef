#include "renderer/shape/ScreenArea.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace thinwall {
namespace {

/// First and past-the-last pixel between two places from -1 to 1 of a side of `count` pixels, with the border.
std::array<int, 2> pixels_between(double least, double most, int count) {
  const auto pixel = [&](double place) { return std::clamp(0.5 * (place + 1), -1.0, 2.0) * count; };
  return {std::clamp(static_cast<int>(std::floor(pixel(least))) - 1, 0, count),
          std::clamp(static_cast<int>(std::ceil(pixel(most))) + 1, 0, count)};
}

ScreenArea pixels_of(const ScreenFrame& frame, ImageSize size) {
  if (frame.least[0] > frame.most[0]) return {};
  const auto [left, right] = pixels_between(frame.least[0], frame.most[0], size.width);
  const auto [bottom, top] = pixels_between(frame.least[1], frame.most[1], size.height);
  return {left, bottom, right - left, top - bottom};
}

}  // namespace

ClipPlace clip_place(const Float3& place, const std::array<float, 16>& matrix) {
  ClipPlace clip{};
  for (std::size_t k = 0; k < 4; ++k) {
    clip[k] = static_cast<double>(matrix[12 + k]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      clip[k] += static_cast<double>(matrix[4 * axis + k]) * static_cast<double>(place[axis]);
    }
  }
  return clip;
}

ClipPlace clip_corner(const Bounds& box, unsigned which, const std::array<float, 16>& matrix) {
  Float3 corner{};
  for (std::size_t axis = 0; axis < 3; ++axis) corner[axis] = (which >> axis & 1U) ? box.most[axis] : box.least[axis];
  return clip_place(corner, matrix);
}

void ScreenFrame::add(const ClipPlace& place) {
  for (std::size_t k = 0; k < 2; ++k) {
    least[k] = std::min(least[k], place[k] / place[3]);
    most[k] = std::max(most[k], place[k] / place[3]);
  }
}

bool ScreenFrame::meets(const ScreenFrame& other) const {
  return least[0] <= other.most[0] && other.least[0] <= most[0] && least[1] <= other.most[1] &&
         other.least[1] <= most[1];
}

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
    const ClipPlace clip = clip_corner(box, which, view_projection);
    if (!(clip[2] > -clip[3])) return false;
  }
  return true;
}

float nearest_depth(const Bounds& box, const std::array<float, 16>& view_projection) {
  double nearest = std::numeric_limits<double>::infinity();
  for (unsigned which = 0; which < 8; ++which) nearest = std::min(nearest, clip_corner(box, which, view_projection)[3]);
  return static_cast<float>(std::max(nearest, 0.0));
}

ScreenArea around(const ScreenArea& a, const ScreenArea& b) {
  if (a.width == 0 || a.height == 0) return b;
  if (b.width == 0 || b.height == 0) return a;
  const int left = std::min(a.left, b.left), bottom = std::min(a.bottom, b.bottom);
  const int right = std::max(a.left + a.width, b.left + b.width);
  return {left, bottom, right - left, std::max(a.bottom + a.height, b.bottom + b.height) - bottom};
}

ScreenArea screen_area(const Bounds& box, const std::array<float, 16>& view_projection, ImageSize size) {
  ScreenFrame frame;
  for (unsigned which = 0; which < 8; ++which) {
    const ClipPlace clip = clip_corner(box, which, view_projection);
    if (!(clip[3] > kNearestPlace)) return {0, 0, size.width, size.height};
    frame.add(clip);
  }
  return pixels_of(frame, size);
}

ScreenArea screen_area(std::span<const ToolVertex> vertices, std::span<const std::uint32_t> corners,
                       const std::array<float, 16>& view_projection, ImageSize size) {
  std::vector<ClipPlace> clips;
  clips.reserve(vertices.size());
  ScreenFrame frame;
  for (const ToolVertex& vertex : vertices) {
    clips.push_back(clip_place(vertex.position, view_projection));
    if (clips.back()[3] > kNearestPlace) frame.add(clips.back());
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ClipPlace &from = clips[corners[i]], &to = clips[corners[i % 3 == 2 ? i - 2 : i + 1]];
    if ((from[3] > kNearestPlace) == (to[3] > kNearestPlace)) continue;
    const double part = (kNearestPlace - from[3]) / (to[3] - from[3]);
    ClipPlace between{0, 0, 0, kNearestPlace};
    for (std::size_t k = 0; k < 2; ++k) between[k] = from[k] + part * (to[k] - from[k]);
    frame.add(between);
  }
  return pixels_of(frame, size);
}

}  // namespace thinwall
