#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// What is asked where a camera stands nowhere yet.
struct CameraQuestions {
  // Into a body along the path of a cut that has no direction: unit, or zero where that is not known.
  std::function<Eigen::Vector3d(const InciseClip&)> inward_along;
  // For each unit vector along which a camera looks, how much of what the clips do is hidden from it.
  std::function<std::vector<double>(std::span<const Eigen::Vector3d>)> hidden_parts;
};

/// Turns a camera that has none of `position`, `facing` and `elevation` towards the action: where tools press from the
/// side or from below, the standard view from above would show the far side of the body, and a wound that is cut from
/// above would lie at its horizon. Fills `camera.facing` or `camera.elevation`; leaves the camera alone where the
/// standard view serves. Each camera without `up` has that against gravity, metres / second^2, where this is not along
/// -z.
void camera_pass(CheckedValue& root, const std::vector<Clip>& timeline, const Eigen::Vector3d& gravity,
                 const CameraQuestions& ask);

}  // namespace thinwall
