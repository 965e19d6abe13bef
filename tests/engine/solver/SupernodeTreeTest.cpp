// What the elimination of a pattern needs to know before any value is known.

#include "engine/solver/SupernodeTree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "engine/solver/NodeOrder.hpp"

namespace thinwall {
namespace {

BlockPattern sphere_pattern(int triangles) {
  const SurfaceMesh mesh = make_sphere(1, triangles);
  return make_block_pattern(static_cast<int>(mesh.vertices.size()), mesh.triangles);
}

/// Rows of each column of the factor, from eliminating unknown after unknown, by the book.
std::vector<std::set<int>> filled(const BlockPattern& pattern, const std::vector<int>& place) {
  std::vector<std::set<int>> rows(pattern.unknowns());
  for (int column = 0; column < pattern.unknowns(); ++column) {
    for (int k = pattern.column_begin[column]; k < pattern.column_begin[column + 1]; ++k) {
      const auto [earlier, later] = std::minmax(place[column], place[pattern.row[k]]);
      if (earlier != later) rows[earlier].insert(later);
    }
  }
  for (std::set<int>& own : rows) {
    if (own.empty()) continue;
    rows[*own.begin()].insert(std::next(own.begin()), own.end());
  }
  return rows;
}

/// With a single unknown for every third vertex, coupled with it, the next one, and the single unknown before.
BlockPattern with_singles(const BlockPattern& pattern) {
  std::vector<std::array<int, 2>> couplings;
  const int singles = pattern.vertices / 3;
  for (int k = 0; k < singles; ++k) {
    const int own = pattern.vertices + k;
    couplings.push_back({3 * k, own});
    couplings.push_back({3 * k + 1, own});
    if (k > 0) couplings.push_back({own - 1, own});
  }
  return extend_block_pattern(pattern, couplings, singles).pattern;
}

/// The unknowns of a value of the matrix.
std::array<int, 2> unknowns_at(const BlockPattern& pattern, int value) {
  const auto column = std::ranges::upper_bound(pattern.column_begin, value) - pattern.column_begin.begin() - 1;
  return {static_cast<int>(column), pattern.row[value]};
}

TEST(SupernodeTree, HasRoomForAllThatEliminationFillsAndCountsItsOperations) {
  const BlockPattern pattern = sphere_pattern(320);
  const SupernodeTree tree = make_supernode_tree(pattern, nested_dissection(pattern));
  const std::vector<std::set<int>> rows = filled(pattern, tree.place);
  double operations = 0;
  std::ptrdiff_t entries = 0, room = 0;
  for (const Supernode& supernode : tree.supernodes) {
    for (int k = 0; k < supernode.pivots; ++k) {
      std::set<int> own;
      for (int later = k + 1; later < supernode.pivots; ++later) own.insert(supernode.first + later);
      own.insert(tree.rows.begin() + supernode.rows_begin,
                 tree.rows.begin() + supernode.rows_begin + supernode.size - supernode.pivots);
      const std::set<int>& wanted = rows[supernode.first + k];
      EXPECT_TRUE(std::ranges::includes(own, wanted));
      operations += static_cast<double>(wanted.size() + 1) * static_cast<double>(wanted.size() + 1);
      entries += static_cast<std::ptrdiff_t>(wanted.size()) + 1;
      room += static_cast<std::ptrdiff_t>(own.size()) + 1;
    }
  }
  EXPECT_EQ(tree.operations, operations);
  // Zeros that are taken along to make fronts larger: 25 % are seen, most of them in fronts at the leaves.
  EXPECT_LT(static_cast<double>(room), 1.3 * static_cast<double>(entries));
}

TEST(SupernodeTree, CoversAllUnknownsInPostorder) {
  const BlockPattern pattern = sphere_pattern(1280);
  const SupernodeTree tree = make_supernode_tree(pattern, nested_dissection(pattern));
  std::vector<int> places = tree.place;
  std::ranges::sort(places);
  std::vector<int> all(pattern.unknowns());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(places, all);
  int next = 0;
  std::vector<int> waiting;
  for (int s = 0; s < static_cast<int>(tree.supernodes.size()); ++s) {
    EXPECT_EQ(tree.supernodes[s].first, next);
    next += tree.supernodes[s].pivots;
    // The fronts below are those that were left last.
    while (!waiting.empty() && tree.supernodes[waiting.back()].parent == s) waiting.pop_back();
    waiting.push_back(s);
  }
  EXPECT_EQ(next, pattern.unknowns());
  EXPECT_EQ(waiting.size(), 1U);
}

TEST(SupernodeTree, EntersEachValueOfTheMatrixWhereItsUnknownsMeet) {
  for (const BlockPattern& pattern : {sphere_pattern(320), with_singles(sphere_pattern(80))}) {
    const SupernodeTree tree = make_supernode_tree(pattern, nested_dissection(pattern));
    std::vector<double> values(pattern.nonzeros()), factor(tree.factor_size, 0.0);
    std::iota(values.begin(), values.end(), 1.0);
    for (const Supernode& supernode : tree.supernodes) enter_values(tree, supernode, values.data(), factor.data());
    EXPECT_EQ(std::ranges::count_if(factor, [](double value) { return value != 0; }), pattern.nonzeros());
    for (const Supernode& supernode : tree.supernodes) {
      std::vector<int> rows(supernode.pivots);
      std::iota(rows.begin(), rows.end(), supernode.first);
      rows.insert(rows.end(), tree.rows.begin() + supernode.rows_begin,
                  tree.rows.begin() + supernode.rows_begin + supernode.size - supernode.pivots);
      for (int column = 0; column < supernode.pivots; ++column) {
        for (int row = 0; row < supernode.size; ++row) {
          const double value = factor[supernode.factor_begin + column * supernode.stride + row];
          if (value == 0) continue;
          const auto [one, other] = unknowns_at(pattern, static_cast<int>(value) - 1);
          EXPECT_EQ(std::minmax({tree.place[one], tree.place[other]}), std::minmax({rows[column], rows[row]}));
        }
      }
    }
  }
}

}  // namespace
}  // namespace thinwall
