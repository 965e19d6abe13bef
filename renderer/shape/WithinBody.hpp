#pragma once

#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// Whether `place` (metres) lies within a surface, whichever way its triangles and caps face: in an open one, where
/// they fill more than half of what is seen around it. A level sheet has no inside.
bool lies_within(const SnapshotSurface& surface, Vector3 place);

}  // namespace thinwall
