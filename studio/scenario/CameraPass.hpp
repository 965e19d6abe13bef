#pragma once

#include "studio/scenario/CheckedValue.hpp"

namespace thinwall {

/// Turns a camera that has none of `position`, `facing` and `elevation` towards the action: where tools press from the
/// side or from below, the standard view from above would show the far side of the body, and a wound that is cut from
/// above would lie at its horizon. Fills `camera.facing` or `camera.elevation`; leaves the camera alone where the
/// standard view serves.
void camera_pass(CheckedValue& root);

}  // namespace thinwall
