#include "renderer/shape/SeenLining.hpp"

#include <optional>

namespace thinwall {
namespace {

/// None for what reaches behind the eye.
std::optional<ScreenFrame> frame_of(const Bounds& box, const std::array<float, 16>& matrix) {
  ScreenFrame frame;
  for (unsigned which = 0; which < 8; ++which) {
    const ClipPlace place = clip_corner(box, which, matrix);
    if (!(place[3] > kNearestPlace)) return std::nullopt;
    frame.add(place);
  }
  return frame;
}

std::optional<ScreenFrame> frame_of(std::span<const SurfaceVertex> vertices, std::span<const std::uint32_t> triangle,
                                    const std::array<float, 16>& matrix) {
  ScreenFrame frame;
  for (const std::uint32_t corner : triangle) {
    const ClipPlace place = clip_place(vertices[corner].position, matrix);
    if (!(place[3] > kNearestPlace)) return std::nullopt;
    frame.add(place);
  }
  return frame;
}

}  // namespace

std::vector<std::uint32_t> seen_lining(std::span<const SurfaceVertex> vertices, std::span<const std::uint32_t> corners,
                                       const Bounds& opening, const std::array<float, 16>& matrix) {
  std::vector<std::uint32_t> seen(corners.begin(), corners.end());
  const std::optional<ScreenFrame> window = frame_of(opening, matrix);
  if (!window) return seen;
  seen.clear();
  for (std::size_t first = 0; first + 2 < corners.size(); first += 3) {
    const auto triangle = corners.subspan(first, 3);
    const std::optional<ScreenFrame> frame = frame_of(vertices, triangle, matrix);
    if (frame && !frame->meets(*window)) continue;
    seen.insert(seen.end(), triangle.begin(), triangle.end());
  }
  return seen;
}

}  // namespace thinwall
