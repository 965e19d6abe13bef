#include "engine/solver/SupernodeTree.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

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

/// The elimination tree in postorder and the rows that each node's column gets. Nodes are named by their place.
struct NodeTree {
  std::vector<int> node;               // (nodes), at each place
  std::vector<int> parent;             // (nodes), -1 at a root
  std::vector<std::vector<int>> rows;  // (nodes), places after the node's own, ascending
  std::vector<int> unknowns;           // (nodes)
};

/// Rows of each node's column below it, as nodes.
std::vector<std::vector<int>> filled_rows(const BlockPattern& pattern, std::span<const int> order,
                                          const std::vector<int>& parent) {
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  std::vector<std::vector<int>> rows(order.size()), children(order.size());
  for (int node = 0; node < pattern.nodes(); ++node) {
    if (parent[node] >= 0) children[parent[node]].push_back(node);
    for (int k = pattern.neighbour_begin[node]; k < pattern.neighbour_begin[node + 1]; ++k) {
      const int other = pattern.neighbours[k];
      if (place[node] < place[other]) {
        rows[node].push_back(other);
      } else {
        rows[other].push_back(node);
      }
    }
  }
  std::vector<int> seen(order.size(), -1);
  for (const int node : order) {
    seen[node] = node;
    for (const int row : rows[node]) seen[row] = node;
    for (const int child : children[node]) {
      for (const int row : rows[child]) {
        if (seen[row] == node) continue;
        seen[row] = node;
        rows[node].push_back(row);
      }
    }
  }
  return rows;
}

/// The tree's nodes, each after its children, of which the one with the most rows comes last: it is the likeliest to
/// share a front with its parent.
std::vector<int> postorder(std::span<const int> order, const std::vector<int>& parent,
                           const std::vector<std::vector<int>>& rows) {
  std::vector<std::vector<int>> children(order.size());
  std::vector<int> waiting, result;
  for (const int node : order) {
    if (parent[node] >= 0) children[parent[node]].push_back(node);
  }
  // Taken down from the roots with each node before its children, the last child first, and then turned round.
  for (const int node : order) {
    if (parent[node] < 0) waiting.push_back(node);
  }
  while (!waiting.empty()) {
    const int node = waiting.back();
    waiting.pop_back();
    result.push_back(node);
    std::ranges::stable_sort(children[node], {}, [&](int child) { return rows[child].size(); });
    waiting.insert(waiting.end(), children[node].begin(), children[node].end());
  }
  std::ranges::reverse(result);
  return result;
}

NodeTree make_node_tree(const BlockPattern& pattern, std::span<const int> order) {
  const std::vector<int> parent = elimination_tree(pattern, order);
  std::vector<std::vector<int>> rows = filled_rows(pattern, order, parent);
  NodeTree tree;
  tree.node = postorder(order, parent, rows);
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[tree.node[k]] = static_cast<int>(k);
  for (const int node : tree.node) {
    tree.parent.push_back(parent[node] < 0 ? -1 : place[parent[node]]);
    tree.unknowns.push_back(pattern.unknowns_of(node));
    for (int& row : rows[node]) row = place[row];
    std::ranges::sort(rows[node]);
    tree.rows.push_back(std::move(rows[node]));
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

int unknowns_of(const NodeTree& tree, const std::vector<int>& nodes) {
  return std::accumulate(nodes.begin(), nodes.end(), 0, [&](int sum, int node) { return sum + tree.unknowns[node]; });
}

/// Nodes whose columns have the same rows, and then chains of such groups with few zeros.
std::vector<NodeGroup> group_nodes(const NodeTree& tree) {
  std::vector<NodeGroup> groups;
  for (int node = 0; node < static_cast<int>(tree.node.size()); ++node) {
    const bool joins =
        node > 0 && tree.parent[node - 1] == node && tree.rows[node - 1].size() == tree.rows[node].size() + 1;
    if (!joins) groups.push_back({.begin = node});
    groups.back().end = node + 1;
    groups.back().pivots += tree.unknowns[node];
    groups.back().rows = unknowns_of(tree, tree.rows[node]);
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

void add_supernodes(const NodeTree& tree, SupernodeTree& result) {
  std::vector<int> first(tree.node.size() + 1, 0), group_of(tree.node.size());
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
    for (const int row : tree.rows[group.end - 1]) {
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
  for (std::size_t node = 0; node < tree.node.size(); ++node) {
    const int rows = unknowns_of(tree, tree.rows[node]);
    for (int k = 1; k <= tree.unknowns[node]; ++k) result.operations += static_cast<double>(rows + k) * (rows + k);
  }
}

void add_entries(const BlockPattern& pattern, SupernodeTree& tree) {
  const int unknowns = pattern.unknowns();
  std::vector<int> supernode_of(unknowns);
  for (std::size_t s = 0; s < tree.supernodes.size(); ++s) {
    const Supernode& supernode = tree.supernodes[s];
    std::fill_n(supernode_of.begin() + supernode.first, supernode.pivots, static_cast<int>(s));
  }
  struct Coupling {
    int value, column, row;  // places
  };
  std::vector<std::vector<Coupling>> couplings(tree.supernodes.size());
  for (int column = 0; column < unknowns; ++column) {
    for (int k = pattern.column_begin[column]; k < pattern.column_begin[column + 1]; ++k) {
      const auto [earlier, later] = std::minmax({tree.place[column], tree.place[pattern.row[k]]});
      couplings[supernode_of[earlier]].push_back({k, earlier, later});
    }
  }
  std::vector<std::vector<int>> children(tree.supernodes.size());
  for (std::size_t s = 0; s < tree.supernodes.size(); ++s) {
    if (tree.supernodes[s].parent >= 0) children[tree.supernodes[s].parent].push_back(static_cast<int>(s));
  }
  LocalPlaces local(unknowns);
  for (std::size_t s = 0; s < tree.supernodes.size(); ++s) {
    Supernode& supernode = tree.supernodes[s];
    local.enter(tree, supernode);
    supernode.entries_begin = static_cast<int>(tree.entries.size());
    for (const Coupling& coupling : couplings[s]) {
      tree.entries.push_back(
          {.value = coupling.value,
           .place = supernode.factor_begin + local[coupling.column] * supernode.stride + local[coupling.row]});
    }
    supernode.entries_end = static_cast<int>(tree.entries.size());
    for (const int child : children[s]) {
      Supernode& below = tree.supernodes[child];
      below.runs_begin = static_cast<int>(tree.runs.size());
      for (int row = 0; row < below.size - below.pivots; ++row) {
        const int to = local[tree.rows[below.rows_begin + row]];
        const bool goes_on = row > 0 && tree.runs.back().to + tree.runs.back().count == to;
        if (!goes_on) tree.runs.push_back({.from = row, .to = to});
        ++tree.runs.back().count;
      }
      below.runs_end = static_cast<int>(tree.runs.size());
    }
  }
}

/// Room for the updates, which wait in two stacks: those of a front's children lie on top of one when its own goes on
/// top of the other.
void find_update_room(SupernodeTree& tree) {
  std::ptrdiff_t used[2] = {0, 0};
  std::vector<std::ptrdiff_t> of_children(tree.supernodes.size(), 0);
  for (std::size_t s = 0; s < tree.supernodes.size(); ++s) {
    const Supernode& supernode = tree.supernodes[s];
    const std::ptrdiff_t own = supernode.update_stride * (supernode.size - supernode.pivots);
    const int parity = supernode.depth % 2;
    used[parity] += own;
    tree.update_size[parity] = std::max(tree.update_size[parity], used[parity]);
    used[1 - parity] -= of_children[s];
    if (supernode.parent >= 0) of_children[supernode.parent] += own;
  }
}

}  // namespace

SupernodeTree make_supernode_tree(const BlockPattern& pattern, std::span<const int> order) {
  assert(static_cast<int>(order.size()) == pattern.nodes());
  const NodeTree nodes = make_node_tree(pattern, order);
  SupernodeTree tree;
  tree.place.resize(pattern.unknowns());
  int place = 0;
  for (const int node : nodes.node) {
    for (int k = 0; k < pattern.unknowns_of(node); ++k) tree.place[pattern.first_unknown(node) + k] = place++;
  }
  add_supernodes(nodes, tree);
  add_entries(pattern, tree);
  find_update_room(tree);
  return tree;
}

}  // namespace thinwall
