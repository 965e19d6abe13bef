#pragma once

#include <string>
#include <vector>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// Makes each body's surface as a run does; gives what was found and done, which is known before any equilibrium.
/// Throws InputErrors with all bodies' mistakes.
std::vector<std::string> body_notes(const Scenario& scenario);

}  // namespace thinwall
