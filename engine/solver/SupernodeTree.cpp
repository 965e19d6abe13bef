#include "engine/solver/SupernodeTree.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "engine/solver/FrontFactor.hpp"
#include "engine/solver/NodeOrder.hpp"

namespace thinwall {
namespace {

/// How many zeros may be taken along to make fronts larger: up to so many pivots, this part of the entries.
struct Relaxation {
  int pivots;
  double zeros;
};
constexpr Relaxation kRelaxations[] = {{12, 0.5}, {24, 0.3}, {60, 0.1}, {1 << 30, 0.05}};

/// Rows of each node's column below it, as nodes.
struct FilledRows {
  std::vector<std::size_t> begin;  // (nodes), into `rows`
  std::vector<int> count;          // (nodes)
  std::vector<int> rows;

  std::span<const int> of(int node) const { return std::span<const int>(rows).subspan(begin[node], count[node]); }
};

/// The children of each node in the order of elimination.
struct ChildLists {
  std::vector<int> begin;  // (nodes + 1), into `children`
  std::vector<int> children;

  ChildLists(std::span<const int> order, const std::vector<int>& parent)
      : begin(order.size() + 1, 0), children(order.size()) {
    for (const int above : parent) {
      if (above >= 0) ++begin[above + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<int> next(begin.begin(), begin.end() - 1);
    for (const int node : order) {
      if (parent[node] >= 0) children[next[parent[node]]++] = node;
    }
  }
  std::span<int> of(int node) { return std::span<int>(children).subspan(begin[node], begin[node + 1] - begin[node]); }
};

/// The elimination tree in postorder. Nodes are named by their place.
struct NodeTree {
  std::vector<int> node;            // (nodes), at each place
  std::vector<int> place;           // (nodes)
  std::vector<int> parent;          // (nodes), -1 at a root
  std::vector<int> unknowns;        // (nodes)
  std::vector<int> rows;            // (nodes), that its column gets below it, as nodes
  std::vector<int> unknowns_below;  // (nodes), the same as unknowns
};

FilledRows filled_rows(const NodeGraph& graph, std::span<const int> order, ChildLists& children) {
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  FilledRows filled{
      .begin = std::vector<std::size_t>(order.size()), .count = std::vector<int>(order.size()), .rows = {}};
  std::vector<int> seen(order.size(), -1);
  for (const int node : order) {
    filled.begin[node] = filled.rows.size();
    seen[node] = node;
    for (const int other : graph.around(node)) {
      if (place[other] < place[node]) continue;
      seen[other] = node;
      filled.rows.push_back(other);
    }
    for (const int child : children.of(node)) {
      const std::size_t begin = filled.begin[child], end = begin + filled.count[child];
      for (std::size_t k = begin; k < end; ++k) {
        const int row = filled.rows[k];
        if (seen[row] == node) continue;
        seen[row] = node;
        filled.rows.push_back(row);
      }
    }
    filled.count[node] = static_cast<int>(filled.rows.size() - filled.begin[node]);
  }
  return filled;
}

/// The tree's nodes, each after its children, of which the one with the most rows comes last: it is the likeliest to
/// share a front with its parent.
std::vector<int> postorder(std::span<const int> order, const std::vector<int>& parent, const FilledRows& filled,
                           ChildLists& children) {
  std::vector<int> waiting, result;
  // Taken down from the roots with each node before its children, the last child first, and then turned round.
  for (const int node : order) {
    if (parent[node] < 0) waiting.push_back(node);
  }
  while (!waiting.empty()) {
    const int node = waiting.back();
    waiting.pop_back();
    result.push_back(node);
    const std::span<int> below = children.of(node);
    std::ranges::stable_sort(below, {}, [&](int child) { return filled.count[child]; });
    waiting.insert(waiting.end(), below.begin(), below.end());
  }
  std::ranges::reverse(result);
  return result;
}

NodeTree make_node_tree(const BlockPattern& pattern, std::span<const int> order, const std::vector<int>& parent,
                        const FilledRows& filled, ChildLists& children) {
  NodeTree tree;
  tree.node = postorder(order, parent, filled, children);
  tree.place.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) tree.place[tree.node[k]] = static_cast<int>(k);
  for (const int node : tree.node) {
    tree.parent.push_back(parent[node] < 0 ? -1 : tree.place[parent[node]]);
    tree.unknowns.push_back(pattern.unknowns_of(node));
    tree.rows.push_back(filled.count[node]);
    int below = 0;
    for (const int row : filled.of(node)) below += pattern.unknowns_of(row);
    tree.unknowns_below.push_back(below);
  }
  return tree;
}

/// Nodes that are eliminated together.
struct NodeGroup {
  int begin = 0, end = 0;  // nodes
  int pivots = 0;          // unknowns
  int rows = 0;            // unknowns below them
  double zeros = 0;        // entries that are taken along
};

double entries_of(const NodeGroup& group) {
  return 0.5 * group.pivots * (group.pivots + 1.0) + static_cast<double>(group.pivots) * group.rows;
}

/// Nodes whose columns have the same rows, and then chains of such groups with few zeros.
std::vector<NodeGroup> group_nodes(const NodeTree& tree) {
  std::vector<NodeGroup> groups;
  for (int node = 0; node < static_cast<int>(tree.node.size()); ++node) {
    const bool joins = node > 0 && tree.parent[node - 1] == node && tree.rows[node - 1] == tree.rows[node] + 1;
    if (!joins) groups.push_back({.begin = node});
    groups.back().end = node + 1;
    groups.back().pivots += tree.unknowns[node];
    groups.back().rows = tree.unknowns_below[node];
  }
  std::vector<NodeGroup> merged;
  for (NodeGroup group : groups) {
    while (!merged.empty()) {
      const NodeGroup& below = merged.back();
      const int parent = tree.parent[below.end - 1];
      if (parent < group.begin || parent >= group.end) break;
      const NodeGroup both{.begin = below.begin,
                           .end = group.end,
                           .pivots = below.pivots + group.pivots,
                           .rows = group.rows,
                           .zeros = below.zeros + group.zeros +
                                    static_cast<double>(below.pivots) * (group.pivots + group.rows - below.rows)};
      const auto fits = [&](const Relaxation& relaxation) {
        return both.pivots <= relaxation.pivots && both.zeros <= relaxation.zeros * entries_of(both);
      };
      if (std::ranges::none_of(kRelaxations, fits)) break;
      group = both;
      merged.pop_back();
    }
    merged.push_back(group);
  }
  return merged;
}

/// Where the unknowns of a front stand in it.
class LocalPlaces {
 public:
  explicit LocalPlaces(int unknowns) : local_(unknowns, -1) {}

  void enter(const SupernodeTree& tree, const Supernode& supernode) {
    for (int k = 0; k < supernode.pivots; ++k) local_[supernode.first + k] = k;
    for (int k = supernode.pivots; k < supernode.size; ++k) {
      local_[tree.rows[supernode.rows_begin + k - supernode.pivots]] = k;
    }
  }
  int operator[](int place) const { return local_[place]; }

 private:
  std::vector<int> local_;  // (unknowns), of the front that was entered last where it has them
};

void add_supernodes(const NodeTree& tree, const FilledRows& filled, SupernodeTree& result) {
  std::vector<int> first(tree.node.size() + 1, 0), group_of(tree.node.size()), rows;
  std::partial_sum(tree.unknowns.begin(), tree.unknowns.end(), first.begin() + 1);
  const std::vector<NodeGroup> groups = group_nodes(tree);
  for (const NodeGroup& group : groups) {
    for (int node = group.begin; node < group.end; ++node) {
      group_of[node] = static_cast<int>(result.supernodes.size());
    }
    Supernode supernode{.first = first[group.begin],
                        .pivots = group.pivots,
                        .size = group.pivots + group.rows,
                        .rows_begin = static_cast<int>(result.rows.size()),
                        .factor_begin = result.factor_size,
                        .stride = up_to_rows(group.pivots + group.rows),
                        .update_stride = up_to_rows(group.rows)};
    rows.clear();
    for (const int row : filled.of(tree.node[group.end - 1])) rows.push_back(tree.place[row]);
    std::ranges::sort(rows);
    for (const int row : rows) {
      for (int k = first[row]; k < first[row + 1]; ++k) result.rows.push_back(k);
    }
    result.factor_size += supernode.stride * supernode.pivots;
    result.largest_front = std::max(result.largest_front, supernode.size);
    result.supernodes.push_back(supernode);
  }
  for (int k = static_cast<int>(groups.size()) - 1; k >= 0; --k) {
    const int above = tree.parent[groups[k].end - 1];
    if (above < 0) continue;
    result.supernodes[k].parent = group_of[above];
    result.supernodes[k].depth = result.supernodes[group_of[above]].depth + 1;
  }
  for (int k = 0; k < static_cast<int>(groups.size()); ++k) {
    const int parent = result.supernodes[k].parent;
    if (parent >= 0) result.supernodes[k].previous_sibling = std::exchange(result.supernodes[parent].last_child, k);
  }
  for (std::size_t node = 0; node < tree.node.size(); ++node) {
    const int below = tree.unknowns_below[node];
    for (int k = 1; k <= tree.unknowns[node]; ++k) result.operations += static_cast<double>(below + k) * (below + k);
  }
}

/// A block of the matrix: two coupled nodes, or one with itself.
struct NodeCoupling {
  int node = 0;    // in whose columns it stands
  int other = 0;   // in whose rows
  int offset = 0;  // of its rows in the first column, from the node's own on
};

/// The couplings that are entered into each supernode: those of the earlier of the two nodes.
struct CouplingLists {
  std::vector<int> begin;  // (supernodes + 1), into `couplings`
  std::vector<NodeCoupling> couplings;

  CouplingLists(const BlockPattern& pattern, const SupernodeTree& tree) : begin(tree.supernodes.size() + 1, 0) {
    std::vector<int> supernode_of(pattern.unknowns());
    for (std::size_t s = 0; s < tree.supernodes.size(); ++s) {
      const Supernode& supernode = tree.supernodes[s];
      std::fill_n(supernode_of.begin() + supernode.first, supernode.pivots, static_cast<int>(s));
    }
    const auto taken_up_by = [&](int node, int other) {
      return supernode_of[std::min(tree.place[pattern.first_unknown(node)], tree.place[pattern.first_unknown(other)])];
    };
    const auto for_each = [&](const auto& visit) {
      for (int node = 0; node < pattern.nodes(); ++node) {
        visit(NodeCoupling{.node = node, .other = node, .offset = 0});
        int offset = pattern.unknowns_of(node);
        for (int k = pattern.neighbour_begin[node]; k < pattern.neighbour_begin[node + 1]; ++k) {
          visit(NodeCoupling{.node = node, .other = pattern.neighbours[k], .offset = offset});
          offset += pattern.unknowns_of(pattern.neighbours[k]);
        }
      }
    };
    for_each([&](const NodeCoupling& one) { ++begin[taken_up_by(one.node, one.other) + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    couplings.resize(begin.back());
    std::vector<int> next(begin.begin(), begin.end() - 1);
    for_each([&](const NodeCoupling& one) { couplings[next[taken_up_by(one.node, one.other)]++] = one; });
  }
};

/// `local`: of the supernode.
MatrixBlock block_of(const BlockPattern& pattern, const NodeCoupling& coupling, const Supernode& supernode,
                     const LocalPlaces& local, const SupernodeTree& tree) {
  const int column = pattern.first_unknown(coupling.node), row = pattern.first_unknown(coupling.other);
  const bool is_turned = tree.place[row] < tree.place[column];
  const std::ptrdiff_t at_column = local[tree.place[column]], at_row = local[tree.place[row]];
  return {.value = pattern.column_begin[column] + coupling.offset,
          .first_length = pattern.column_begin[column + 1] - pattern.column_begin[column],
          .place = supernode.factor_begin +
                   (is_turned ? at_row * supernode.stride + at_column : at_column * supernode.stride + at_row),
          .columns = static_cast<char>(pattern.unknowns_of(coupling.node)),
          .rows = static_cast<char>(pattern.unknowns_of(coupling.other)),
          .is_diagonal = coupling.node == coupling.other,
          .is_turned = is_turned};
}

template <int columns, int rows, typename Number>
void enter_block(const MatrixBlock& block, std::ptrdiff_t stride, const double* values, Number* factor) {
  const std::ptrdiff_t column_step = block.is_turned ? 1 : stride, row_step = block.is_turned ? stride : 1;
  int from = block.value;
  // A diagonal block's columns begin with the diagonal.
  for (int c = 0; c < columns; ++c) {
    Number* to = factor + block.place + c * column_step;
    for (int r = block.is_diagonal ? c : 0; r < rows; ++r) to[r * row_step] = static_cast<Number>(values[from + r - c]);
    from += block.first_length - c;
  }
}

void add_blocks(const BlockPattern& pattern, SupernodeTree& tree) {
  const CouplingLists lists(pattern, tree);
  const auto supernodes = static_cast<int>(tree.supernodes.size());
  std::vector<int> first_child(supernodes, -1), next_child(supernodes, -1);
  for (int s = supernodes - 1; s >= 0; --s) {
    const int parent = tree.supernodes[s].parent;
    if (parent >= 0) next_child[s] = std::exchange(first_child[parent], s);
  }
  tree.blocks.reserve(lists.couplings.size());
  LocalPlaces local(pattern.unknowns());
  for (int s = 0; s < supernodes; ++s) {
    Supernode& supernode = tree.supernodes[s];
    local.enter(tree, supernode);
    supernode.blocks_begin = lists.begin[s];
    supernode.blocks_end = lists.begin[s + 1];
    for (int k = lists.begin[s]; k < lists.begin[s + 1]; ++k) {
      tree.blocks.push_back(block_of(pattern, lists.couplings[k], supernode, local, tree));
    }
    for (int child = first_child[s]; child >= 0; child = next_child[child]) {
      Supernode& below = tree.supernodes[child];
      below.runs_begin = static_cast<int>(tree.runs.size());
      for (int row = 0; row < below.size - below.pivots; ++row) {
        const int to = local[tree.rows[below.rows_begin + row]];
        const bool goes_on = row > 0 && tree.runs.back().to + tree.runs.back().count == to && to != supernode.pivots;
        if (!goes_on) tree.runs.push_back({.from = row, .to = to});
        ++tree.runs.back().count;
      }
      below.runs_end = static_cast<int>(tree.runs.size());
    }
  }
}

}  // namespace

SupernodeTree make_supernode_tree(const BlockPattern& pattern, std::span<const int> order) {
  const NodeGraph graph = graph_of(pattern);
  return make_supernode_tree(pattern, graph, order, elimination_tree(graph, order));
}

SupernodeTree make_supernode_tree(const BlockPattern& pattern, const NodeGraph& graph, std::span<const int> order,
                                  const std::vector<int>& parent) {
  assert(static_cast<int>(order.size()) == pattern.nodes() && graph.nodes() == pattern.nodes());
  ChildLists children(order, parent);
  const FilledRows filled = filled_rows(graph, order, children);
  const NodeTree nodes = make_node_tree(pattern, order, parent, filled, children);
  SupernodeTree tree;
  tree.place.resize(pattern.unknowns());
  int place = 0;
  for (const int node : nodes.node) {
    for (int k = 0; k < pattern.unknowns_of(node); ++k) tree.place[pattern.first_unknown(node) + k] = place++;
  }
  add_supernodes(nodes, filled, tree);
  add_blocks(pattern, tree);
  return tree;
}

template <typename Number>
void enter_values(const SupernodeTree& tree, const Supernode& supernode, const double* values, Number* factor) {
  for (int k = supernode.blocks_begin; k < supernode.blocks_end; ++k) {
    const MatrixBlock& block = tree.blocks[k];
    if (block.columns == 3) {
      block.rows == 3 ? enter_block<3, 3>(block, supernode.stride, values, factor)
                      : enter_block<3, 1>(block, supernode.stride, values, factor);
    } else {
      block.rows == 3 ? enter_block<1, 3>(block, supernode.stride, values, factor)
                      : enter_block<1, 1>(block, supernode.stride, values, factor);
    }
  }
}
template void enter_values(const SupernodeTree& tree, const Supernode& supernode, const double* values, double* factor);
template void enter_values(const SupernodeTree& tree, const Supernode& supernode, const double* values, float* factor);

}  // namespace thinwall
