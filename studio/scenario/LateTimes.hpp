#pragma once

#include <string>
#include <vector>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// What of a scenario is to happen after the end (seconds) that its run is planned for, and so never does: each with
/// its path, as from a time in another unit or a clip that has become shorter.
std::vector<std::string> late_times(const Scenario& scenario, double end);

}  // namespace thinwall
