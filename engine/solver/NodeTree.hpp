#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/solver/BlockPattern.hpp"
#include "engine/solver/NodeOrder.hpp"

namespace thinwall {

/// Rows of each node's column below it, as nodes, in no order that counts.
struct FilledRows {
  std::vector<std::size_t> begin;  // (nodes), into `rows`
  std::vector<int> count;          // (nodes)
  std::vector<int> unknowns;       // (nodes), of all these rows
  std::vector<int> rows;           // shared by a node and its last child where they can be

  std::span<const int> of(int node) const { return std::span<const int>(rows).subspan(begin[node], count[node]); }
};

/// The elimination tree in postorder, of the children of a node that with the most rows last: it is the likeliest to
/// share a front with its parent. Nodes are named by their place.
struct NodeTree {
  std::vector<int> node;            // (nodes), at each place
  std::vector<int> place;           // (nodes)
  std::vector<int> parent;          // (nodes), -1 at a root
  std::vector<int> unknowns;        // (nodes)
  std::vector<int> rows;            // (nodes), that its column gets below it, as nodes
  std::vector<int> unknowns_below;  // (nodes), the same as unknowns
  FilledRows filled;                // by the names that nodes have in the pattern
};

/// `order`: of the nodes. `graph`: of the pattern's nodes. `parent`: (nodes), see `elimination_tree`.
NodeTree make_node_tree(const BlockPattern& pattern, const NodeGraph& graph, std::span<const int> order,
                        const std::vector<int>& parent);

}  // namespace thinwall
