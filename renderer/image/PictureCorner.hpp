#pragma once

#include <array>
#include <string_view>

namespace thinwall {

/// Where something smaller stands in a picture.
enum class PictureCorner { kUpperLeft, kUpperRight, kLowerLeft, kLowerRight };

/// What scenarios and messages call the corners, in that order.
inline constexpr std::array<std::string_view, 4> kCornerWords{"upper_left", "upper_right", "lower_left", "lower_right"};

inline bool is_left(PictureCorner corner) {
  return corner == PictureCorner::kUpperLeft || corner == PictureCorner::kLowerLeft;
}

inline bool is_upper(PictureCorner corner) {
  return corner == PictureCorner::kUpperLeft || corner == PictureCorner::kUpperRight;
}

}  // namespace thinwall
