#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/shape/SurfaceVertices.hpp"
#include "renderer/snapshot/BorderEdges.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// What a wall that is open somewhere shows besides its outer side.
struct WallDepth {
  std::vector<SurfaceVertex> lining;  // (vertices) of the inner side; its triangles are those of the wall turned over
  std::vector<SurfaceVertex> rim;     // of what joins both sides along the borders
  std::vector<std::uint32_t> rim_corners;  // (3 x triangles), into `rim`
};

/// How a wall that is open somewhere goes through to its inner side.
struct WallWays {
  std::vector<double> thickness;  // (vertices), metres, of the wall as it is drawn; none where its depth is not drawn
  std::vector<double> lean;       // (vertices), sine of the angle by which the way leans into the wound
  std::vector<Vector3> through;   // (vertices), of length one, from the outer side to the inner one
  std::vector<Vector3> forward;   // (vertices), of length one, of lips: into the wound; elsewhere zero
};

WallWays wall_ways(const SnapshotSurface& surface, std::span<const SurfaceVertex> wall,
                   std::span<const BorderEdge> borders);

/// The inner side lies the wall's thickness behind the outer one, as it is now: tissue keeps its volume, but a wall
/// that is crushed to less than two thirds of its area does not grow further, and one that turns more sharply than its
/// thickness is drawn thinner there, as is one around a hole that is small beside its thickness, and one against whose
/// inner side another part of it lies (thin_to_room). `wall`: what wall_vertices gives for the surface. Where two
/// pieces of a border meet at less than 60 degrees the rim is smooth.
WallDepth wall_depth(const SnapshotSurface& surface, std::span<const SurfaceVertex> wall,
                     std::span<const BorderEdge> borders, const WallWays& ways);

/// The inner side of a wall without a border, (vertices), likewise, but that it is nowhere drawn thicker than half the
/// radius at which it bulges. `wall` as above.
std::vector<SurfaceVertex> inner_side(const SnapshotSurface& surface, std::span<const SurfaceVertex> wall);

}  // namespace thinwall
