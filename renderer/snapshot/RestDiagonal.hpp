#pragma once

#include <span>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Metres, of the box around the stress-free vertices of surfaces; 0 where there are none.
double rest_diagonal(std::span<const SnapshotSurface> surfaces);

}  // namespace thinwall
