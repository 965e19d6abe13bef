#pragma once

#include "studio/scenario/CheckedValue.hpp"

namespace thinwall {

/// Turns a camera that has neither `position` nor `facing` towards the action: where tools press from the side or from
/// below, the standard view from above would show the far side of the body. Fills `camera.facing`; leaves the camera
/// alone where the standard view serves.
void camera_pass(CheckedValue& root);

}  // namespace thinwall
