#include "engine/solver/SupernodeTree.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "engine/solver/FrontFactor.hpp"
#include "engine/solver/NodeTree.hpp"

namespace thinwall {
namespace {

/// How many zeros may be taken along to make fronts larger: up to so many pivots, this part of the entries.
struct Relaxation {
  int pivots;
  double zeros;
};
constexpr Relaxation kRelaxations[] = {{12, 0.5}, {24, 0.3}, {60, 0.1}, {1 << 30, 0.05}};

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

/// Rows below each group, as places of nodes, ascending.
struct GroupRows {
  std::vector<int> begin;  // (groups + 1), into `rows`
  std::vector<int> rows;

  /// In the order of their places each row is entered into the groups that have it: no list needs sorting.
  GroupRows(const NodeTree& tree, const std::vector<NodeGroup>& groups) : begin(groups.size() + 1, 0) {
    const auto rows_of = [&](std::size_t group) { return tree.filled.of(tree.node[groups[group].end - 1]); };
    std::vector<int> at_place(tree.node.size() + 1, 0);  // into `having`
    for (std::size_t g = 0; g < groups.size(); ++g) {
      begin[g + 1] = begin[g] + static_cast<int>(rows_of(g).size());
      for (const int row : rows_of(g)) ++at_place[tree.place[row] + 1];
    }
    std::partial_sum(at_place.begin(), at_place.end(), at_place.begin());
    std::vector<int> having(begin.back()), next(at_place.begin(), at_place.end() - 1);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      for (const int row : rows_of(g)) having[next[tree.place[row]]++] = static_cast<int>(g);
    }
    rows.resize(begin.back());
    next.assign(begin.begin(), begin.end() - 1);
    for (int place = 0; place < static_cast<int>(tree.node.size()); ++place) {
      for (int k = at_place[place]; k < at_place[place + 1]; ++k) rows[next[having[k]]++] = place;
    }
  }
};

/// Each below the one that takes up its update, and beside its siblings.
void join_supernodes(const NodeTree& tree, const std::vector<NodeGroup>& groups, SupernodeTree& result) {
  std::vector<int> group_of(tree.node.size());
  for (std::size_t k = 0; k < groups.size(); ++k) {
    std::fill(group_of.begin() + groups[k].begin, group_of.begin() + groups[k].end, static_cast<int>(k));
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
}

void add_supernodes(const NodeTree& tree, SupernodeTree& result) {
  std::vector<int> first(tree.node.size() + 1, 0);
  std::partial_sum(tree.unknowns.begin(), tree.unknowns.end(), first.begin() + 1);
  const std::vector<NodeGroup> groups = group_nodes(tree);
  const GroupRows below(tree, groups);
  result.supernodes.reserve(groups.size());
  result.rows.reserve(3 * below.rows.size());
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const NodeGroup& group = groups[k];
    Supernode supernode{.first = first[group.begin],
                        .pivots = group.pivots,
                        .size = group.pivots + group.rows,
                        .rows_begin = static_cast<int>(result.rows.size()),
                        .factor_begin = result.factor_size,
                        .stride = up_to_rows(group.pivots + group.rows),
                        .update_stride = up_to_rows(group.rows)};
    for (int row = below.begin[k]; row < below.begin[k + 1]; ++row) {
      const int place = below.rows[row];
      for (int unknown = first[place]; unknown < first[place + 1]; ++unknown) result.rows.push_back(unknown);
    }
    result.factor_size += supernode.stride * supernode.pivots;
    result.largest_front = std::max(result.largest_front, supernode.size);
    result.supernodes.push_back(supernode);
  }
  join_supernodes(tree, groups, result);
  for (std::size_t node = 0; node < tree.node.size(); ++node) {
    const int rows = tree.unknowns_below[node];
    for (int k = 1; k <= tree.unknowns[node]; ++k) result.operations += static_cast<double>(rows + k) * (rows + k);
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
  const NodeTree nodes = make_node_tree(pattern, graph, order, parent);
  SupernodeTree tree;
  tree.place.resize(pattern.unknowns());
  int place = 0;
  for (const int node : nodes.node) {
    for (int k = 0; k < pattern.unknowns_of(node); ++k) tree.place[pattern.first_unknown(node) + k] = place++;
  }
  add_supernodes(nodes, tree);
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
