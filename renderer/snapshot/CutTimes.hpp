#pragma once

#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// (vertices), seconds: for each vertex of `now` that lies at a cut the time at which it came to, which is `time` for
/// those that did not in `before`; kNeverCut for all others. Vertices keep their numbers over a cut.
std::vector<float> cut_times(const SnapshotTopology& now, const SnapshotTopology& before, double time);

}  // namespace thinwall
