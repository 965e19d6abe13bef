#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/solver/BlockPattern.hpp"
#include "engine/solver/NodeOrder.hpp"

namespace thinwall {

/// Consecutive unknowns, in their order, whose columns of the factor have the same rows, but for a few zeros: they are
/// eliminated together in one front (Duff and Reid 1983). Fronts stand in postorder.
struct Supernode {
  int first = 0;                         // place of its first unknown
  int pivots = 0;                        // unknowns that it eliminates
  int size = 0;                          // unknowns of its front
  int parent = -1;                       // supernode whose front takes up its update
  int last_child = -1;                   // supernode, of those whose updates it takes up
  int previous_sibling = -1;             // supernode, with the same parent
  int depth = 0;                         // below its root
  int rows_begin = 0;                    // into `rows`: size - pivots of them
  std::ptrdiff_t factor_begin = 0;       // of its columns in the factor
  std::ptrdiff_t stride = 0;             // of its columns
  std::ptrdiff_t update_stride = 0;      // of its update
  int runs_begin = 0, runs_end = 0;      // into `runs`
  int blocks_begin = 0, blocks_end = 0;  // into `blocks`
};

/// Rows of an update that stay together in the front above, within its pivots or behind them.
struct RowRun {
  int from = 0;  // in the update
  int to = 0;    // in the front above
  int count = 0;
};

/// Where a block of the matrix goes: two coupled nodes, or one with itself, of which only the lower triangle is kept.
struct MatrixBlock {
  int value = 0;             // in the matrix, of its first entry
  int first_length = 0;      // entries of the matrix's column there; the columns of a node become shorter by one
  std::ptrdiff_t place = 0;  // in the factor, of its first entry
  char columns = 0, rows = 0;
  bool is_diagonal = false;
  bool is_turned = false;  // its columns are rows of the factor
};

/// What the elimination of a pattern in a given order needs to know before any value is known.
struct SupernodeTree {
  std::vector<Supernode> supernodes;
  std::vector<int> place;  // (unknowns), in the order of elimination
  std::vector<int> rows;   // places below the pivots of each supernode, ascending
  std::vector<RowRun> runs;
  std::vector<MatrixBlock> blocks;
  std::ptrdiff_t factor_size = 0;
  int largest_front = 0;
  double operations = 0;  // floating-point operations, without those on zeros that supernodes bring

  std::span<const RowRun> runs_of(const Supernode& supernode) const {
    return std::span(runs).subspan(supernode.runs_begin, supernode.runs_end - supernode.runs_begin);
  }
};

/// `order` of the nodes is put in postorder of its elimination tree, which changes neither fill nor operations.
/// `graph`: of the pattern's nodes. `parent`: (nodes), see `elimination_tree`.
SupernodeTree make_supernode_tree(const BlockPattern& pattern, const NodeGraph& graph, std::span<const int> order,
                                  const std::vector<int>& parent);
SupernodeTree make_supernode_tree(const BlockPattern& pattern, std::span<const int> order);

/// Puts the matrix's entries of a supernode's own columns where they go; the rest of `factor` stays as it is.
/// Of double or of single precision.
template <typename Number>
void enter_values(const SupernodeTree& tree, const Supernode& supernode, const double* values, Number* factor);

}  // namespace thinwall
