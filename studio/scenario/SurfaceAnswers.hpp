#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// What a camera that nobody has placed asks of the bodies' stress-free surfaces, which take a while to make. Without
/// answers it has the standard view.
struct SurfaceAnswers {
  /// The mean inward normal of a body's surface along the path of a cut: unit, or zero where there is none.
  std::function<Eigen::Vector3d(const BodyScenario&, const InciseClip&)> inward_normal = {};
  /// For each unit vector along which a camera looks, the part of the places where tools are to come upon walls that
  /// bodies hide from it, 0 to 1.
  std::function<std::vector<double>(const Scenario&, std::span<const Eigen::Vector3d> facings)> hidden_parts = {};
};

}  // namespace thinwall
