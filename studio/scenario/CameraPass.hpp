#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// Into a body along the path of a cut that has no direction: unit, or zero where that is not known.
using InwardAlong = std::function<Eigen::Vector3d(const InciseClip&)>;

/// Turns a camera that has none of `position`, `facing` and `elevation` towards the action: where tools press from the
/// side or from below, the standard view from above would show the far side of the body, and a wound that is cut from
/// above would lie at its horizon. Fills `camera.facing` or `camera.elevation`; leaves the camera alone where the
/// standard view serves. `inward_along` is asked of cuts without direction, where a camera stands nowhere yet.
void camera_pass(CheckedValue& root, const std::vector<Clip>& timeline, const InwardAlong& inward_along);

}  // namespace thinwall
