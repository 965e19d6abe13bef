#pragma once

#include <string>
#include <utility>
#include <vector>

namespace thinwall {

std::string thinwall_version();

/// The licence under which this build as a whole may be passed on, and why.
std::string effective_licence();

/// Both, as `--version` says them: two lines, the last without its end.
std::string version_text();

/// Names and versions of what this build was made with and of, in a fixed order.
std::vector<std::pair<std::string, std::string>> component_versions();

}  // namespace thinwall
