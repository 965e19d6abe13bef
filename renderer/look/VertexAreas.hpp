#pragma once

#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// (vertices), metres^2: a third of the stress-free triangles around each, so that they sum to the wall's area.
std::vector<double> vertex_areas(const SnapshotTopology& topology);

}  // namespace thinwall
