// Orders of nodes that are carried over when the pattern grows.

#include "engine/solver/NodeOrder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "engine/mesh/MeshTopology.hpp"
#include "engine/mesh/Shapes.hpp"
#include "engine/solver/SparseFactor.hpp"
#include "engine/solver/SupernodeTree.hpp"

namespace thinwall {
namespace {

/// Parents from eliminating node after node, by the book.
std::vector<int> eliminated(const BlockPattern& pattern, const std::vector<int>& order) {
  std::vector<std::set<int>> around(pattern.nodes());
  for (int node = 0; node < pattern.nodes(); ++node) {
    for (int k = pattern.neighbour_begin[node]; k < pattern.neighbour_begin[node + 1]; ++k) {
      around[node].insert(pattern.neighbours[k]);
      around[pattern.neighbours[k]].insert(node);
    }
  }
  std::vector<int> place(order.size()), parent(order.size(), -1);
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  for (const int node : order) {
    for (const int one : around[node]) {
      around[one].erase(node);
      if (parent[node] < 0 || place[one] < place[parent[node]]) parent[node] = one;
      for (const int other : around[node]) {
        if (one != other) around[one].insert(other);
      }
    }
  }
  return parent;
}

TEST(NodeOrder, FindsTheTreeThatEliminationGives) {
  const SurfaceMesh mesh = make_sphere(1, 320);
  const int vertices = static_cast<int>(mesh.vertices.size());
  const BlockPattern pattern = make_block_pattern(vertices, mesh.triangles);
  std::vector<int> order(vertices);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(7);
  for (int turn = 0; turn < 3; ++turn) {
    EXPECT_EQ(elimination_tree(graph_of(pattern), order), eliminated(pattern, order));
    std::ranges::shuffle(order, random);
  }
}

/// A sphere, and the same cut along its meridian at y = 0, x > 0: the vertices there are doubled.
struct CutSphere {
  SurfaceMesh mesh;
  std::vector<Eigen::Vector3i> cut;
  int vertices = 0;

  explicit CutSphere(int triangles, double to) : mesh(make_sphere(1, triangles)), cut(mesh.triangles) {
    vertices = static_cast<int>(mesh.vertices.size());
    std::vector<int> twin(vertices, -1);
    for (Eigen::Vector3i& triangle : cut) {
      const Eigen::Vector3d center =
          (mesh.vertices[triangle[0]] + mesh.vertices[triangle[1]] + mesh.vertices[triangle[2]]) / 3;
      if (center.y() < 0) continue;
      for (int& corner : triangle) {
        const Eigen::Vector3d& place = mesh.vertices[corner];
        if (place.x() < 0 || place.z() > to || std::abs(place.y()) > 0.5 / std::sqrt(triangles)) continue;
        if (twin[corner] < 0) twin[corner] = vertices++;
        corner = twin[corner];
      }
    }
  }
};

TEST(NodeOrder, OfAPatternThatHasGrownKeepsAllNodesAndFactorsNearlyAsCheap) {
  for (const double to : {-0.5, 0.0, 0.5, 2.0}) {
    const CutSphere sphere(1280, to);
    const int before = static_cast<int>(sphere.mesh.vertices.size());
    ASSERT_GT(sphere.vertices, before + 3);
    const BlockPattern old_pattern = make_block_pattern(before, sphere.mesh.triangles);
    const BlockPattern pattern = make_block_pattern(sphere.vertices, sphere.cut);
    const SparseFactor old_factor(old_pattern), carried(pattern, old_factor), own(pattern);
    // Seen: 1.09 to 1.25, the most for the longest cut, which itself parts the graph: only an own order makes use of
    // it.
    EXPECT_LT(carried.operations(), 1.3 * own.operations()) << to;
    EXPECT_LE(carried.operations() / pattern.nodes(),
              SparseFactor::kWorseOrder * old_factor.operations() / old_pattern.nodes());
    // The same where nodes are numbered anyhow.
    std::vector<int> order(before);
    std::iota(order.begin(), order.end(), 0);
    const NodeGraph old_graph = graph_of(old_pattern);
    std::vector<int> extended = extended_order(
        {.graph = old_graph, .order = order, .parent = elimination_tree(old_graph, order), .vertices = before},
        graph_of(pattern), sphere.vertices);
    std::ranges::sort(extended);
    ASSERT_EQ(extended.size(), static_cast<std::size_t>(sphere.vertices));
    for (int node = 0; node < sphere.vertices; ++node) EXPECT_EQ(extended[node], node);
  }
}

/// A pattern with a single unknown at each edge, coupled with all corners of the triangles there and their other edges,
/// as the turns of a shell are; corners of triangles that share an edge are coupled too.
BlockPattern with_edges(int vertices, const std::vector<Eigen::Vector3i>& triangles) {
  const MeshTopology topology = topology_of(vertices, triangles);
  std::vector<std::array<int, 2>> couplings;
  for (int edge = 0; edge < static_cast<int>(topology.edges.size()); ++edge) {
    std::vector<int> nodes;
    for (const int triangle : triangles_at(topology, edge)) {
      for (int k = 0; k < 3; ++k) {
        nodes.push_back(triangles[triangle][k]);
        nodes.push_back(vertices + topology.triangle_edges[triangle][k]);
      }
    }
    for (const int one : nodes) {
      for (const int other : nodes) {
        if (one < other) couplings.push_back({one, other});
      }
    }
  }
  const BlockPattern pattern = make_block_pattern(vertices, triangles);
  return extend_block_pattern(pattern, couplings, static_cast<int>(topology.edges.size())).pattern;
}

TEST(NodeOrder, PutsSingleUnknownsAmongTheVerticesAsCheaplyAsDissectingAllNodes) {
  const SurfaceMesh mesh = make_sphere(1, 1280);
  const BlockPattern pattern = with_edges(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  BlockPattern all_alike;
  all_alike.vertices = pattern.nodes();
  all_alike.neighbour_begin = pattern.neighbour_begin;
  all_alike.neighbours = pattern.neighbours;
  std::vector<int> order = nested_dissection(pattern);
  const double operations = make_supernode_tree(pattern, order).operations;
  // Seen: 0.998.
  EXPECT_LT(operations, 1.1 * make_supernode_tree(pattern, nested_dissection(all_alike)).operations);
  std::ranges::sort(order);
  ASSERT_EQ(order.size(), static_cast<std::size_t>(pattern.nodes()));
  for (int node = 0; node < pattern.nodes(); ++node) EXPECT_EQ(order[node], node);
}

TEST(NodeOrder, OfACutShellIsCarriedOverThoughItsSingleUnknownsAreNumberedAnew) {
  const CutSphere sphere(1280, 0.0);
  const BlockPattern old_pattern = with_edges(static_cast<int>(sphere.mesh.vertices.size()), sphere.mesh.triangles);
  const BlockPattern pattern = with_edges(sphere.vertices, sphere.cut);
  ASSERT_GT(pattern.singles, old_pattern.singles);
  const SparseFactor old_factor(old_pattern), own(pattern);
  SparseFactor carried(pattern, old_factor);
  // Seen: 1.15.
  EXPECT_LT(carried.operations(), 1.3 * own.operations());
  EXPECT_NE(carried.operations(), own.operations()) << "the order was not carried over";
}

TEST(NodeOrder, IsFoundAnewWhereTheOldOneNoLongerFits) {
  // Everything is coupled with three new nodes' worth of far couplings: the branches of the old tree are gone.
  const SurfaceMesh mesh = make_sphere(1, 1280);
  const int vertices = static_cast<int>(mesh.vertices.size());
  const BlockPattern pattern = make_block_pattern(vertices, mesh.triangles);
  std::vector<std::array<int, 2>> far;
  for (int v = 0; v + 7 < vertices; v += 7) far.push_back({v, (v * 31 + 5) % vertices});
  const BlockPattern tangled = extend_block_pattern(pattern, far).pattern;
  const SparseFactor factor(pattern), carried(tangled, factor), own(tangled);
  EXPECT_EQ(carried.operations(), own.operations());
}

TEST(NodeOrder, ThatIsCarriedOverSolvesTheSame) {
  const CutSphere sphere(320, 0.5);
  const BlockPattern pattern = make_block_pattern(sphere.vertices, sphere.cut);
  SparseFactor carried(
      pattern, SparseFactor(make_block_pattern(static_cast<int>(sphere.mesh.vertices.size()), sphere.mesh.triangles)));
  std::vector<double> values(pattern.nonzeros(), -1);
  for (int column = 0; column < pattern.unknowns(); ++column) values[pattern.column_begin[column]] = 40;
  ASSERT_TRUE(carried.factorize(values));
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(pattern.unknowns(), -1, 2);
  Eigen::VectorXd solved = right, back;
  carried.solve(solved);
  multiply(pattern, values, solved, back);
  EXPECT_LT((back - right).lpNorm<Eigen::Infinity>(), 1e-13);
}

}  // namespace
}  // namespace thinwall
