#pragma once

#include <span>
#include <vector>

#include "renderer/picture/WallThickness.hpp"

namespace thinwall {

/// How far from a cut a vertex counts as near it, metres on the stress-free wall; as in shaders/pattern.glsl.
inline constexpr double kWoundReach = 0.004;

/// Nearness of vertices that no cut is near.
inline constexpr float kUncut = -20;

/// (vertices), 1 at the lips of cuts, falling evenly with the way along the edges, to 0 at kWoundReach; below 0 only
/// where the triangles at a cut reach farther, so that it falls evenly within them too. The borders that were there
/// before any cut are no lips: along a cut each vertex has a twin with the same stress-free position.
std::vector<float> nearness_to_cuts(const SnapshotTopology& topology, std::span<const BorderEdge> borders);

}  // namespace thinwall
