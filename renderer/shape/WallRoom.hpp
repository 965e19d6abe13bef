#pragma once

#include <span>
#include <vector>

#include "renderer/shape/SurfaceVertices.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Makes a wall thin where another part of it lies against its inner side nearer than it is thick, as in an organ that
/// has run empty: so that no inner side comes out of the outer side of the other wall. What lay within the thickness at
/// rest is the same part, as around a puncture. `wall`: what wall_vertices gives for the surface; `thickness`:
/// (vertices), metres, behind it.
void thin_to_room(const SnapshotSurface& surface, std::span<const SurfaceVertex> wall, std::vector<double>& thickness);

}  // namespace thinwall
