#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// Makes the scenario of a tree that passed all checks: only copies, everything is there and in range. File, name,
/// title of a scenario without one, warnings and the resolved text are the caller's.
Scenario build_scenario(const CheckedValue& root);

}  // namespace thinwall
