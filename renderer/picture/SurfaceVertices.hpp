#pragma once

#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// What the tissue shader reads of a vertex.
struct SurfaceVertex {
  Float3 position{};  // metres
  Float3 normal{};    // of length one, outward, smooth across the triangles around
  Float3 rest{};      // metres, stress-free position: where the pattern of the tissue sticks
  float blanch = 0;   // 0 to 1: how far pressure and stretch have driven the blood out
  float hollow = 0;   // -1 to 1: how far the surface around rises above (dent, positive) or falls away
};

/// Vertices of the wall, numbered as in the surface.
std::vector<SurfaceVertex> wall_vertices(const SnapshotSurface& surface);

/// Vertices of the caps, three for each, with the normal of the cap.
std::vector<SurfaceVertex> cap_vertices(const SnapshotSurface& surface);

}  // namespace thinwall
