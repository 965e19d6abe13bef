#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

// What lies among the goldens and is compared with nothing: a line each, with the file, the reason and the cure.

/// Of a scenario's folder: approvals of moments or of a video that the scenario has no golden of, and files that no
/// approval names. Nothing where an approval cannot be read, which the comparison tells.
std::vector<std::string> unasked_goldens(const Scenario& scenario, const std::filesystem::path& folder);

/// The scenarios that have goldens.
struct GoldenOwners {
  std::filesystem::path scenes;         // the folder of their files
  std::span<const Scenario> scenarios;  // those that can be read
  std::set<std::string> broken;         // the names of the others
};

/// Folders in `root` that none of them has; where a scenario is gone that may be renamed to one of them, which as yet
/// has no folder and asks for all that is approved, how the approvals are kept.
std::vector<std::string> unasked_folders(const std::filesystem::path& root, const GoldenOwners& owners);

}  // namespace thinwall
