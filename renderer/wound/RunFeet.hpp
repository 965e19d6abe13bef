#pragma once

#include <span>
#include <vector>

#include "renderer/wound/RunPath.hpp"

namespace thinwall {

/// (vertices), of lips: 1 where a run begins, less beside it along the same lip, to 0: how much of what is on its way
/// into the run stands there.
std::vector<double> run_feet(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                             std::span<const char> is_lip, std::span<const FluidRun> runs);

}  // namespace thinwall
