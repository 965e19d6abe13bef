#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studio/golden/GoldenRun.hpp"

namespace thinwall {

/// One HTML page without anything beside it: a list of all goldens, and for what is not ok the pictures to compare. It
/// opens from a file and asks no network. Equal runs give equal bytes. Throws GoldenError when a golden cannot be read.
std::string golden_report(const std::vector<JudgedScenario>& scenarios, const std::filesystem::path& goldens);

}  // namespace thinwall
