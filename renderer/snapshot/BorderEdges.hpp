#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// A triangle's edge with nothing beyond it: at a cut, or where a wall ends.
struct BorderEdge {
  std::uint32_t start = 0, end = 0;  // vertices, in the triangle's sense
  std::uint32_t triangle = 0;        // of the wall
};

/// The edges of the wall that belong to one triangle of wall and caps alone, in the order of the triangles.
std::vector<BorderEdge> border_edges(const SnapshotTopology& topology);

/// (vertices), 1 where a vertex lies at a cut: on a border, and another one on a border has its stress-free position,
/// or an edge between such ones passes through it, which only one side of the cut divides; the tips between two such
/// vertices count too. The borders that were there before any cut are none. `borders`: what
/// border_edges gives.
std::vector<char> cut_lips(const SnapshotTopology& topology, std::span<const BorderEdge> borders);

}  // namespace thinwall
