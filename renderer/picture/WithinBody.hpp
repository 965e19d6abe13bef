#pragma once

#include "renderer/picture/Vector.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Whether `place` (metres) lies within a surface that its triangles and caps close, whichever way they face. Sheets
/// and opened walls have no inside: they close less than half of what is seen around it.
bool lies_within(const SnapshotSurface& surface, Vector3 place);

}  // namespace thinwall
