#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/image/Image.hpp"
#include "renderer/shape/ScreenArea.hpp"

namespace thinwall {

/// Pixels that one sample in their middle does not tell truly, since the colour differs much from that of a neighbour.
/// They take four more in their corners, which neighbours share: a second picture, shifted by half a pixel, has them
/// all.
struct FinePixels {
  ScreenArea area;                    // of the picture, holds all of them and of those corners; empty if there are none
  std::vector<std::uint8_t> is_fine;  // (area.height x area.width), 0 or 1, from the lower left corner, row by row
  std::vector<std::uint8_t> is_corner;  // (area.height x area.width), whether the corner on the upper right is wanted
};

/// Those within `area` of a picture. `picture`: (4 x width x height), RGBA, from the lower left corner, row by row.
/// `bare`: the same without fluids, or empty where there are none. Pixels that show fluid are fine too: its slopes are
/// known for two by two pixels at once.
FinePixels find_fine_pixels(std::span<const std::uint8_t> picture, std::span<const std::uint8_t> bare, int width,
                            const ScreenArea& area);

/// What the scene is drawn over, (4 x area.width x area.height): the backdrop where corners are wanted, elsewhere the
/// picture. Both are whole pictures of `width`.
std::vector<std::uint8_t> with_backdrop(const FinePixels& fine, std::span<const std::uint8_t> picture,
                                        std::span<const std::uint8_t> backdrop, int width);

/// (area.width x area.height): `corner` where corners are wanted, `other` elsewhere.
std::vector<std::uint32_t> at_corners(const FinePixels& fine, std::uint32_t corner, std::uint32_t other);

/// Makes the fine pixels of a picture of their middle, which it has, by half, and their four corners; at the borders of
/// the area those of the nearest pixel. `corners`: (4 x area.width x area.height), the corner on the upper right of
/// each pixel.
void add_corners(const FinePixels& fine, std::span<const std::uint8_t> corners, std::span<std::uint8_t> picture,
                 int width);

}  // namespace thinwall
