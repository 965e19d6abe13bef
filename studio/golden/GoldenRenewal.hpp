#pragma once

#include <filesystem>
#include <string>

#include "studio/golden/GoldenComparison.hpp"

namespace thinwall {

/// Makes today's picture the golden of its time and driver: image, state, and last the entry in approval.json.
/// Throws PictureFailure, GoldenError.
void renew_golden(const Scenario& scenario, const GoldenPicture& picture, const std::string& driver,
                  const std::filesystem::path& folder, const std::string& who, const std::string& why);

/// Who approves: git's user name, else the login name.
std::string approver();

}  // namespace thinwall
