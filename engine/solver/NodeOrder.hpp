#pragma once

#include <span>
#include <vector>

#include "engine/solver/BlockPattern.hpp"

namespace thinwall {

/// The graph of a pattern's nodes, or of the first of them, both ways.
struct NodeGraph {
  std::vector<int> begin;       // (nodes + 1), into `neighbours`
  std::vector<int> neighbours;  // of each node, ascending

  int nodes() const { return static_cast<int>(begin.size()) - 1; }
  std::span<const int> around(int node) const {
    return std::span<const int>(neighbours).subspan(begin[node], begin[node + 1] - begin[node]);
  }
};
NodeGraph graph_of(const BlockPattern& pattern);
NodeGraph graph_of(const BlockPattern& pattern, int nodes);

/// A fill-reducing order of the nodes: nested dissection of the vertices' graph (METIS), which single unknowns join as
/// further nodes do in `extended_order`: a quarter of the time that dissecting all takes, for as few operations.
std::vector<int> nested_dissection(const BlockPattern& pattern);

/// Parent of each node in the elimination tree of a graph under an order of its nodes, (nodes), -1 at a root: the first
/// of the nodes after it that it is coupled with once those before it are eliminated (Liu 1990).
std::vector<int> elimination_tree(const NodeGraph& graph, std::span<const int> order);

/// An order for a graph that has grown, `after`, from a good one of the graph before, whose vertices come first, and
/// the elimination tree under that order. Couplings that are new stay cheap when they join a node with those above or
/// below it in the tree: a further node comes right after the lowest node of which all that it is coupled with lie
/// above or below, and vertices that are newly coupled across branches of the tree make room in the same way. Couplings
/// that are gone do no harm. Single unknowns, those beyond the first `vertices_before` and `vertices_after` nodes, are
/// numbered anew by whoever makes a pattern, and join the vertices anew.
struct GraphBefore {
  const NodeGraph& graph;
  std::span<const int> order;      // (nodes)
  const std::vector<int>& parent;  // (nodes), see `elimination_tree`
  int vertices = 0;
};
std::vector<int> extended_order(const GraphBefore& before, const NodeGraph& after, int vertices);

}  // namespace thinwall
