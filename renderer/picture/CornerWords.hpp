#pragma once

#include <array>
#include <string_view>

namespace thinwall {

/// What scenarios and messages call the corners of a picture, in the order of PictureCorner.
inline constexpr std::array<std::string_view, 4> kCornerWords{"upper_left", "upper_right", "lower_left", "lower_right"};

}  // namespace thinwall
