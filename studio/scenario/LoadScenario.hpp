#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "studio/scenario/InputError.hpp"
#include "studio/scenario/Scenario.hpp"
#include "studio/scenario/SurfaceAnswers.hpp"

namespace thinwall {

/// Reads and checks a scenario file: parse, then the passes include, parameters, units, references, lints, then build.
/// `overrides` are names and values of parameters, as in `--set depth=4mm`. Reads no mesh, but its file must exist.
/// Throws InputErrors with all mistakes of the file and its includes.
Scenario load_scenario(const std::filesystem::path& file,
                       const std::vector<std::pair<std::string, std::string>>& overrides,
                       const SurfaceAnswers& answers = {});

}  // namespace thinwall
