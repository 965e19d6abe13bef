#pragma once

#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// What the tissue shader reads of a vertex.
struct SurfaceVertex {
  Float3 position{};    // metres
  Float3 normal{};      // of length one, outward, smooth across the triangles around
  Float3 rest{};        // metres, stress-free position: where the pattern of the tissue sticks
  float blanch = 0;     // 0 to 1: how far pressure and stretch have driven the blood out
  float curvature = 0;  // 1 / metre, mean of both directions: positive in a dent, negative on a bulge
  float thickness = 1;  // of now over stress-free, as the area there tells
  float wound = 0;      // within a rim the depth, from 0 outside to 1 inside; below 0 where the outer layer covers it
};

/// Vertices of the wall, numbered as in the surface.
std::vector<SurfaceVertex> wall_vertices(const SnapshotSurface& surface);

/// Vertices of the caps, three for each, with the normal of the cap.
std::vector<SurfaceVertex> cap_vertices(const SnapshotSurface& surface);

}  // namespace thinwall
