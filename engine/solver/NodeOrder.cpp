#include "engine/solver/NodeOrder.hpp"

#include <metis.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <iterator>
#include <mutex>
#include <new>
#include <numeric>
#include <utility>

namespace thinwall {
namespace {

/// METIS draws from the one random number generator of the process: two orders at once would become other orders.
std::mutex one_at_a_time;

std::vector<int> places_of(std::span<const int> order) {
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  return place;
}

/// A tree whose nodes stand in an order with children before their parents.
struct OrderedTree {
  std::vector<int> parent;
  std::vector<int> place;
  std::vector<int> first, size;  // of the subtree of each node: where it begins in a walk from the roots, and its nodes

  OrderedTree(std::vector<int> the_parent, std::span<const int> order)
      : parent(std::move(the_parent)), place(places_of(order)), first(order.size()), size(order.size(), 1) {
    int roots = 0;  // nodes of the trees so far
    for (const int node : order) {
      if (parent[node] >= 0) size[parent[node]] += size[node];
    }
    std::vector<int> next(order.size());  // where the subtree of the next child begins
    for (std::size_t k = order.size(); k-- > 0;) {
      const int node = order[k];
      int& begin = parent[node] >= 0 ? next[parent[node]] : roots;
      first[node] = begin;
      begin += size[node];
      next[node] = first[node] + 1;
    }
  }

  /// Whether the one lies above the other or is it.
  bool is_above(int upper, int lower) const {
    return first[upper] <= first[lower] && first[lower] < first[upper] + size[upper];
  }

  /// The lowest node that lies above both or is one of them; -1 where there is none.
  int meeting_of(int one, int other) const {
    while (one >= 0 && !is_above(one, other)) one = parent[one];
    return one;
  }
};

/// The lowest node of which all the others lie above or below.
int lowest_common(const OrderedTree& tree, std::vector<int> nodes) {
  std::ranges::sort(nodes, {}, [&](int node) { return tree.place[node]; });
  int lowest = nodes.front();
  for (const int node : nodes) {
    if (!tree.is_above(node, lowest)) lowest = tree.meeting_of(node, lowest);
    if (lowest < 0) return nodes.back();
  }
  return lowest;
}

}  // namespace

NodeGraph graph_of(const BlockPattern& pattern, int nodes) {
  // Larger neighbours ascend: those beyond the nodes come last.
  const auto larger = [&](int node) {
    const auto begin = pattern.neighbours.begin() + pattern.neighbour_begin[node];
    const auto end = pattern.neighbours.begin() + pattern.neighbour_begin[node + 1];
    return std::span<const int>(begin, nodes == pattern.nodes() ? end : std::lower_bound(begin, end, nodes));
  };
  NodeGraph graph{.begin = std::vector<int>(nodes + 1, 0), .neighbours = {}};
  for (int node = 0; node < nodes; ++node) {
    for (const int other : larger(node)) ++graph.begin[node + 1], ++graph.begin[other + 1];
  }
  std::partial_sum(graph.begin.begin(), graph.begin.end(), graph.begin.begin());
  graph.neighbours.resize(graph.begin.back());
  std::vector<int> next(graph.begin.begin(), graph.begin.end() - 1);
  for (int node = 0; node < nodes; ++node) {
    for (const int other : larger(node)) {
      graph.neighbours[next[node]++] = other;
      graph.neighbours[next[other]++] = node;
    }
  }
  return graph;
}

NodeGraph graph_of(const BlockPattern& pattern) {
  return graph_of(pattern, pattern.nodes());
}

std::vector<int> elimination_tree(const NodeGraph& graph, std::span<const int> order) {
  const std::vector<int> place = places_of(order);
  std::vector<int> parent(order.size(), -1), reached(order.size(), -1);
  for (const int node : order) {
    for (int below : graph.around(node)) {
      if (place[below] >= place[node]) continue;
      // Up to the root of what is eliminated so far, with the path cut short for the next time.
      while (reached[below] != -1 && reached[below] != node) {
        const int next = reached[below];
        reached[below] = node;
        below = next;
      }
      if (reached[below] == -1) {
        reached[below] = node;
        parent[below] = node;
      }
    }
  }
  return parent;
}

namespace {

/// The graph without all nodes but the first.
NodeGraph first_nodes(const NodeGraph& graph, int nodes) {
  NodeGraph first{.begin = {0}, .neighbours = {}};
  for (int node = 0; node < nodes; ++node) {
    for (const int other : graph.around(node)) {
      if (other < nodes) first.neighbours.push_back(other);
    }
    first.begin.push_back(static_cast<int>(first.neighbours.size()));
  }
  return first;
}

/// An order for a graph that has grown, see `extended_order`; `before` has no single unknowns.
std::vector<int> grown_order(const GraphBefore& before, const NodeGraph& graph) {
  const std::span<const int> order = before.order;
  const int known = before.graph.nodes();
  assert(static_cast<int>(order.size()) == known && graph.nodes() >= known);
  assert(known > 0 || graph.nodes() == 0);
  const OrderedTree tree(before.parent, order);
  std::vector<int> anchor(graph.nodes(), -1);  // known node after which a node comes
  std::vector<char> moves(graph.nodes(), 0);
  for (int node = 0; node < graph.nodes(); ++node) {
    if (node < known) anchor[node] = node;
    moves[node] = node >= known;
  }
  for (int node = 0; node < known; ++node) {
    for (const int other : graph.around(node)) {
      if (other >= known || tree.place[other] < tree.place[node] || moves[other]) continue;
      moves[node] = moves[node] || !tree.is_above(other, node);
    }
  }
  std::vector<std::vector<int>> followers(known);
  for (int node = 0; node < graph.nodes(); ++node) {
    if (!moves[node]) continue;
    std::vector<int> around;
    for (const int other : graph.around(node)) {
      if (anchor[other] >= 0) around.push_back(anchor[other]);
    }
    if (node < known) around.push_back(node);
    anchor[node] = around.empty() ? order.back() : lowest_common(tree, around);
    followers[anchor[node]].push_back(node);
  }
  std::vector<int> extended;
  for (const int node : order) {
    if (!moves[node]) extended.push_back(node);
    extended.insert(extended.end(), followers[node].begin(), followers[node].end());
  }
  return extended;
}

}  // namespace

std::vector<int> nested_dissection(const BlockPattern& pattern) {
  static_assert(sizeof(idx_t) == sizeof(int));
  int vertices = pattern.vertices;
  NodeGraph graph = graph_of(pattern, vertices);
  std::vector<int> order(vertices), place(vertices);
  std::iota(order.begin(), order.end(), 0);
  if (!graph.neighbours.empty()) {
    const std::lock_guard<std::mutex> turn(one_at_a_time);
    if (METIS_NodeND(&vertices, graph.begin.data(), graph.neighbours.data(), nullptr, nullptr, order.data(),
                     place.data()) != METIS_OK) {
      throw std::bad_alloc();
    }
  }
  if (pattern.singles == 0) return order;
  return grown_order({.graph = graph, .order = order, .parent = elimination_tree(graph, order), .vertices = vertices},
                     graph_of(pattern));
}

std::vector<int> extended_order(const GraphBefore& before, const NodeGraph& after, int vertices) {
  assert(before.vertices <= before.graph.nodes() && before.vertices <= vertices && vertices <= after.nodes());
  if (before.graph.nodes() == before.vertices && after.nodes() == vertices) return grown_order(before, after);
  const NodeGraph graph = first_nodes(before.graph, before.vertices), grown = first_nodes(after, vertices);
  std::vector<int> order;
  std::ranges::copy_if(before.order, std::back_inserter(order), [&](int node) { return node < before.vertices; });
  const std::vector<int> of_vertices = grown_order(
      {.graph = graph, .order = order, .parent = elimination_tree(graph, order), .vertices = before.vertices}, grown);
  return grown_order(
      {.graph = grown, .order = of_vertices, .parent = elimination_tree(grown, of_vertices), .vertices = vertices},
      after);
}

}  // namespace thinwall
