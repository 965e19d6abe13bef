#pragma once

#include <span>
#include <vector>

#include "renderer/shape/SurfaceVertices.hpp"
#include "renderer/snapshot/BorderEdges.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// How a wall goes through to its inner side where it has been cut.
struct LipShape {
  std::vector<Vector3> through;  // (vertices), of length one, from the outer side to the inner one
  std::vector<Vector3> forward;  // (vertices), of length one, of lips: out of the wall, into the wound; elsewhere zero
  std::vector<double> room;      // (vertices), metres, of lips: half of the way to the other lip; elsewhere 0
  std::vector<std::uint32_t> next;  // (vertices), of lips: the next one along the border, or kNoLip

  static constexpr std::uint32_t kNoLip = 0xffffffff;
};

/// Away from lips the way through is against the outward normal. Slack lips wrinkle within their own thickness, which a
/// wall does not: near them the way is averaged over neighbours. `wall`: what wall_vertices gives for the surface.
LipShape lip_shape(const SnapshotSurface& surface, std::span<const SurfaceVertex> wall,
                   std::span<const BorderEdge> borders);

/// Half of each lip's value and half of the mean of its neighbours' along the border, `turns` times. (vertices)
void even_along_lips(const LipShape& lips, int turns, std::vector<double>& values);

}  // namespace thinwall
