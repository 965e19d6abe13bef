#pragma once

namespace thinwall {

/// Times closer than this are the same: what rounding leaves between a sum of time steps, frame / fps and the times
/// that a scenario names.
inline constexpr double kSameTime = 1e-9;  // seconds

}  // namespace thinwall
