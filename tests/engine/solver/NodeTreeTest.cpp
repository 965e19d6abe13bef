// The elimination tree of nodes and what each of their columns has below it.

#include "engine/solver/NodeTree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <random>
#include <set>
#include <span>
#include <vector>

#include "engine/mesh/Shapes.hpp"

namespace thinwall {
namespace {

/// Nodes below each node in its column of the factor, from eliminating node after node, by the book.
std::vector<std::set<int>> filled(const NodeGraph& graph, const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  std::vector<std::set<int>> below(order.size());
  for (const int node : order) {
    for (const int other : graph.around(node)) {
      if (place[other] > place[node]) below[node].insert(other);
    }
  }
  for (const int node : order) {
    if (below[node].empty()) continue;
    const int parent = *std::ranges::min_element(below[node], {}, [&](int other) { return place[other]; });
    std::ranges::copy_if(below[node], std::inserter(below[parent], below[parent].end()),
                         [&](int other) { return other != parent; });
  }
  return below;
}

/// Two spheres and a vertex alone, with a single unknown for every third vertex.
BlockPattern pattern_of_parts() {
  const SurfaceMesh mesh = make_sphere(1, 320);
  const int vertices = static_cast<int>(mesh.vertices.size());
  std::vector<Eigen::Vector3i> triangles = mesh.triangles;
  for (const Eigen::Vector3i& triangle : mesh.triangles) triangles.push_back(triangle.array() + vertices);
  const BlockPattern pattern = make_block_pattern(2 * vertices + 1, triangles);
  std::vector<std::array<int, 2>> couplings;
  const int singles = pattern.vertices / 3;
  for (int k = 0; k < singles; ++k) couplings.push_back({3 * k, pattern.vertices + k});
  return extend_block_pattern(pattern, couplings, singles).pattern;
}

TEST(NodeTree, EachColumnHasTheRowsThatEliminationFillsWhateverTheOrder) {
  const BlockPattern pattern = pattern_of_parts();
  const NodeGraph graph = graph_of(pattern);
  std::vector<int> order = nested_dissection(pattern);
  std::mt19937 random(11);
  for (int turn = 0; turn < 3; ++turn) {
    const NodeTree tree = make_node_tree(pattern, graph, order, elimination_tree(graph, order));
    const std::vector<std::set<int>> wanted = filled(graph, order);
    for (int place = 0; place < pattern.nodes(); ++place) {
      const int node = tree.node[place];
      const std::span<const int> rows = tree.filled.of(node);
      EXPECT_EQ(std::set<int>(rows.begin(), rows.end()), wanted[node]);
      EXPECT_EQ(rows.size(), wanted[node].size());
      EXPECT_EQ(tree.rows[place], static_cast<int>(wanted[node].size()));
      const int unknowns = std::accumulate(wanted[node].begin(), wanted[node].end(), 0,
                                           [&](int sum, int row) { return sum + pattern.unknowns_of(row); });
      EXPECT_EQ(tree.unknowns_below[place], unknowns);
    }
    std::ranges::shuffle(order, random);
  }
}

TEST(NodeTree, StandsInPostorderWithTheFullestChildLast) {
  const BlockPattern pattern = pattern_of_parts();
  const NodeGraph graph = graph_of(pattern);
  const std::vector<int> order = nested_dissection(pattern);
  const NodeTree tree = make_node_tree(pattern, graph, order, elimination_tree(graph, order));
  std::vector<int> fullest(pattern.nodes(), 0), last(pattern.nodes(), -1);
  for (int place = 0; place < pattern.nodes(); ++place) {
    const int parent = tree.parent[place];
    if (parent < 0) continue;
    EXPECT_GT(parent, place);
    fullest[parent] = std::max(fullest[parent], tree.rows[place]);
    last[parent] = place;
  }
  for (int place = 0; place < pattern.nodes(); ++place) {
    if (last[place] < 0) continue;
    EXPECT_EQ(last[place], place - 1);
    EXPECT_EQ(tree.rows[last[place]], fullest[place]);
  }
}

}  // namespace
}  // namespace thinwall
