#pragma once

#include <span>
#include <vector>

#include "engine/cutting/CutPatch.hpp"
#include "engine/cutting/PathSnapping.hpp"

namespace thinwall {

/// A path as edges of a patch.
struct InsertedPath {
  bool complete = false;           // false: some node or segment finds no room
  std::vector<int> vertices;       // in the order of the path, each joined with the next by an edge
  std::vector<int> node_vertices;  // (nodes) where each node came to lie; -1 if not reached
  int troubled_node = -1;          // the node at which a path that is not complete got stuck
};

/// Makes the straight lines between nodes edges of the patch: nodes split edges and faces or take over a vertex nearby
/// that is free to move there; a line in a facet becomes an edge by flips, goes through a vertex that is close to it,
/// and splits an edge of the path itself that it crosses. Marks the edges, those of the open border left out.
InsertedPath insert_path(CutPatch& patch, std::span<const PathNode> nodes);

/// Takes the mark from edges of the path that would not open: single ones whose ends both stay single. True when edges
/// of the path are left.
bool drop_closed_edges(CutPatch& patch);

}  // namespace thinwall
