#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// What no single value of a camera shows, of each camera and its keyframes: one that stands where it looks, that looks
/// along its `up`, or whose lens folds the picture over before the border of what it fills of the recording.
void check_cameras(const CheckedValue& root, Diagnostics& diagnostics);

}  // namespace thinwall
