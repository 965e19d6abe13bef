#pragma once

#include <string>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// Which labels, arrows and recorded points of a scenario lie so far from the walls that they belong to that another
/// place must be meant, as with a wrong unit, and which highlights meet no wall: a sentence for each, with its path.
std::vector<std::string> far_places(const Scenario& scenario, const Snapshot& snapshot);

}  // namespace thinwall
