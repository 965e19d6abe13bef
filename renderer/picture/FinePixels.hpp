#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/image/Image.hpp"
#include "renderer/picture/ScreenArea.hpp"

namespace thinwall {

/// Pixels that one sample in their middle does not tell truly, since the colour differs much from that of a neighbour.
/// They take four more in their corners, which neighbours share: a second picture, shifted by half a pixel, has them
/// all.
struct FinePixels {
  ScreenArea area;                      // holds all of them and of those corners; empty where there are none
  std::vector<std::uint8_t> is_fine;    // (area.height x area.width), 0 or 1, from the lower left corner, row by row
  std::vector<std::uint8_t> is_corner;  // (area.height x area.width), whether the corner on the upper right is wanted
};

/// `pixels`: (4 x width x height), RGBA, from the lower left corner, row by row. `bare`: the same picture without
/// fluids, or empty where there are none. Pixels that show fluid are fine too: its slopes are known for two by two
/// pixels at once.
FinePixels find_fine_pixels(std::span<const std::uint8_t> pixels, std::span<const std::uint8_t> bare, ImageSize size);

/// What is within `area` of such a picture: (4 x area.width x area.height).
std::vector<std::uint8_t> cut_out(std::span<const std::uint8_t> pixels, ImageSize size, const ScreenArea& area);

/// `middles` with the backdrop where corners are wanted: what the scene is drawn over. `middles`: (4 x area.width x
/// area.height); `backdrop`: of the whole picture, which has `size`.
std::vector<std::uint8_t> with_backdrop(const FinePixels& fine, std::span<const std::uint8_t> middles,
                                        std::span<const std::uint8_t> backdrop, ImageSize size);

/// (area.width x area.height): `corner` where corners are wanted, `other` elsewhere.
std::vector<std::uint32_t> at_corners(const FinePixels& fine, std::uint32_t corner, std::uint32_t other);

/// `middles` with fine pixels made of their middle, by half, and their four corners; at the borders of the area those
/// of the nearest pixel. `middles` and `corners`: (4 x area.width x area.height), the corner on the upper right of each
/// pixel.
std::vector<std::uint8_t> with_corners(const FinePixels& fine, std::span<const std::uint8_t> middles,
                                       std::span<const std::uint8_t> corners);

}  // namespace thinwall
