#pragma once

#include <string>
#include <vector>

#include "studio/record/Moment.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// What in a scenario is at a time after the end of its run or at a place off its walls, as from a wrong unit: a
/// sentence for each. `first`: the first moment of the run; `second_duration`: how long the take lasts that it is
/// compared with, seconds, 0 where there is none.
std::vector<std::string> misplaced_notes(const Scenario& scenario, const Moment& first, double second_duration);

}  // namespace thinwall
