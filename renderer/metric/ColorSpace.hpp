#pragma once

#include <array>

namespace thinwall {

using ColorMatrix = std::array<std::array<double, 3>, 3>;

/// Linear sRGB to XYZ, white (1, 1, 1) at Y = 1: from the primaries and white point D65 of IEC 61966-2-1.
const ColorMatrix& rgb_to_xyz();

/// Its inverse.
const ColorMatrix& xyz_to_rgb();

/// XYZ of (1, 1, 1).
const std::array<double, 3>& white_xyz();

/// Linear light, 0 to 1, of each 8-bit sRGB level (IEC 61966-2-1).
const std::array<float, 256>& linear_levels();

/// CIE 1976 L*, a*, b* of linear sRGB against the white of `white_xyz`.
std::array<double, 3> lab_of_linear(const std::array<double, 3>& rgb);

}  // namespace thinwall
