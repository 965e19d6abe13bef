#include "engine/solver/NodeOrder.hpp"

#include <metis.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <mutex>
#include <new>
#include <numeric>

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

  /// The lowest node that lies above both or is one of them; -1 where there is none.
  int meeting_of(int one, int other) const {
    while (one != other && one >= 0 && other >= 0) {
      int& lower = place[one] < place[other] ? one : other;
      lower = parent[lower];
    }
    return one == other ? one : -1;
  }
  bool is_above(int upper, int lower) const { return meeting_of(upper, lower) == upper; }
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

NodeGraph graph_of(const BlockPattern& pattern) {
  const int nodes = pattern.nodes();
  NodeGraph graph{.begin = std::vector<int>(nodes + 1, 0), .neighbours = {}};
  for (int node = 0; node < nodes; ++node) {
    const int begin = pattern.neighbour_begin[node], end = pattern.neighbour_begin[node + 1];
    graph.begin[node + 1] += end - begin;
    for (int k = begin; k < end; ++k) ++graph.begin[pattern.neighbours[k] + 1];
  }
  std::partial_sum(graph.begin.begin(), graph.begin.end(), graph.begin.begin());
  graph.neighbours.resize(graph.begin.back());
  std::vector<int> next(graph.begin.begin(), graph.begin.end() - 1);
  for (int node = 0; node < nodes; ++node) {
    for (int k = pattern.neighbour_begin[node]; k < pattern.neighbour_begin[node + 1]; ++k) {
      const int other = pattern.neighbours[k];
      graph.neighbours[next[node]++] = other;
      graph.neighbours[next[other]++] = node;
    }
  }
  return graph;
}

std::vector<int> nested_dissection(const BlockPattern& pattern) {
  static_assert(sizeof(idx_t) == sizeof(int));
  std::vector<int> order(pattern.nodes()), place(pattern.nodes());
  std::iota(order.begin(), order.end(), 0);
  if (pattern.neighbours.empty()) return order;
  NodeGraph graph = graph_of(pattern);
  int nodes = pattern.nodes();
  const std::lock_guard<std::mutex> turn(one_at_a_time);
  if (METIS_NodeND(&nodes, graph.begin.data(), graph.neighbours.data(), nullptr, nullptr, order.data(), place.data()) !=
      METIS_OK) {
    throw std::bad_alloc();
  }
  return order;
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

std::vector<int> extended_order(const BlockPattern& before, std::span<const int> order, const BlockPattern& after) {
  assert(static_cast<int>(order.size()) == before.nodes() && after.nodes() >= before.nodes());
  const OrderedTree tree{.parent = elimination_tree(graph_of(before), order), .place = places_of(order)};
  const NodeGraph graph = graph_of(after);
  const int known = before.nodes();
  std::vector<int> anchor(after.nodes(), -1);  // known node after which a node comes
  std::vector<char> moves(after.nodes(), 0);
  for (int node = 0; node < after.nodes(); ++node) {
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
  for (int node = 0; node < after.nodes(); ++node) {
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

}  // namespace thinwall
