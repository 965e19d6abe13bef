#pragma once

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// A surface as it was before a cut, on the topology that it has after it: as if the cut had been there already, still
/// closed. Vertices keep their numbers over a cut, new ones follow; where a vertex is new or has moved on the
/// stress-free surface, it lies where that place of the earlier surface lay. Of two places at an older wound the one
/// nearer to the later position counts. Fields of vertices go over alike; those of changed triangles are taken from
/// `later`.
SnapshotSurface carried_over(const SnapshotSurface& earlier, const SnapshotSurface& later);

}  // namespace thinwall
