#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/shape/ScreenArea.hpp"

namespace thinwall {

/// The triangles of a closed body's lining that may be seen from outside, (3 x triangles): only through the opening of
/// its wall, so only those that lie behind `opening` on the screen. `corners`: (3 x triangles), into `vertices`;
/// `matrix`: world to clip coordinates, column by column. All of them where something reaches behind the eye.
std::vector<std::uint32_t> seen_lining(std::span<const SurfaceVertex> vertices, std::span<const std::uint32_t> corners,
                                       const Bounds& opening, const std::array<float, 16>& matrix);

}  // namespace thinwall
