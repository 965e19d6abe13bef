#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

// What lies among the goldens and is compared with nothing: a line each, with the file, the reason and the cure.

/// Of a scenario's folder: approvals of moments or of a video that the scenario has no golden of, and files that no
/// approval names. Nothing where an approval cannot be read, which the comparison tells.
std::vector<std::string> unasked_goldens(const Scenario& scenario, const std::filesystem::path& folder);

/// Folders in `root` that no scenario of these names has.
std::vector<std::string> unasked_folders(const std::filesystem::path& root, const std::set<std::string>& scenarios);

}  // namespace thinwall
