#pragma once

#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// The surfaces that are no scenery, in their order; all of them where all are.
std::vector<const SnapshotSurface*> acting_surfaces(const Snapshot& snapshot);

}  // namespace thinwall
