#pragma once

namespace thinwall {

/// Metres across beyond which a surface is no organ, and its unit doubted.
inline constexpr double kTooSmall = 1e-3, kTooLarge = 2;

}  // namespace thinwall
