#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "studio/scenario/InputError.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// The mean inward normal of a body's stress-free surface along the path of a cut: unit, or zero where there is none.
using InwardNormal = std::function<Eigen::Vector3d(const BodyScenario&, const InciseClip&)>;

/// Reads and checks a scenario file: parse, then the passes include, parameters, units, references, lints, then build.
/// `overrides` are names and values of parameters, as in `--set depth=4mm`. Reads no mesh, but its file must exist.
/// `inward_normal` is asked where a camera that nobody has placed is to look into a wound; without it such a camera
/// has the standard view. Throws InputErrors with all mistakes of the file and its includes.
Scenario load_scenario(const std::filesystem::path& file,
                       const std::vector<std::pair<std::string, std::string>>& overrides,
                       const InwardNormal& inward_normal = {});

}  // namespace thinwall
