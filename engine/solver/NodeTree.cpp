#include "engine/solver/NodeTree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace thinwall {
namespace {

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
  std::span<const int> of(int node) const {
    return std::span<const int>(children).subspan(begin[node], begin[node + 1] - begin[node]);
  }

  /// The child with the most comes last.
  void sort_by(const std::vector<int>& count) {
    for (std::size_t node = 0; node + 1 < begin.size(); ++node) {
      if (begin[node + 1] - begin[node] < 2) continue;
      std::stable_sort(children.begin() + begin[node], children.begin() + begin[node + 1],
                       [&](int one, int other) { return count[one] < count[other]; });
    }
  }
};

/// The tree's nodes in postorder, each right after its last child.
std::vector<int> postorder(std::span<const int> order, const std::vector<int>& parent, const ChildLists& children) {
  // Taken down from the roots with each node before its children, the last child first, and then turned round.
  std::vector<int> waiting, result;
  result.reserve(order.size());
  for (const int node : order) {
    if (parent[node] < 0) waiting.push_back(node);
  }
  while (!waiting.empty()) {
    const int node = waiting.back();
    waiting.pop_back();
    result.push_back(node);
    const std::span<const int> below = children.of(node);
    waiting.insert(waiting.end(), below.begin(), below.end());
  }
  std::ranges::reverse(result);
  return result;
}

/// What a node has below it, found along chains of nodes, each the last child of the next, whose rows overlap.
class RowChain {
 public:
  RowChain(const BlockPattern& pattern, FilledRows& filled)
      : pattern_(pattern), filled_(filled), chain_of_(pattern.nodes(), -1), at_(pattern.nodes()) {}

  /// Begins with the rows of the child before without the node itself, if no row of the chain changes by that.
  bool go_on(int node, int child) {
    if (at_[node] >= unchanging_end_) return false;
    begin_ = filled_.begin[child];
    const int other = filled_.rows[begin_];
    std::swap(filled_.rows[at_[node]], filled_.rows[begin_++]);
    std::swap(at_[other], at_[node]);
    unknowns_ -= pattern_.unknowns_of(node);
    return true;
  }
  /// Begins without a row.
  void begin(int node) {
    chain_ = chain_of_[node] = node;
    begin_ = filled_.rows.size();
    unchanging_end_ = std::numeric_limits<std::size_t>::max();
    unknowns_ = 0;
  }
  void add(int row) {
    if (std::exchange(chain_of_[row], chain_) == chain_) return;
    at_[row] = filled_.rows.size();
    filled_.rows.push_back(row);
    unknowns_ += pattern_.unknowns_of(row);
  }
  void end(int node) {
    filled_.begin[node] = begin_;
    filled_.count[node] = static_cast<int>(filled_.rows.size() - begin_);
    filled_.unknowns[node] = unknowns_;
    unchanging_end_ = std::min(unchanging_end_, filled_.rows.size());
  }

 private:
  const BlockPattern& pattern_;
  FilledRows& filled_;
  int chain_ = -1;                  // its first node
  std::vector<int> chain_of_;       // (nodes), that was the last to have each row
  std::vector<std::size_t> at_;     // (nodes), where that row stands
  std::size_t begin_ = 0;           // of the rows of the node
  std::size_t unchanging_end_ = 0;  // of the rows that the first node had: among these all may change places
  int unknowns_ = 0;                // of the rows of the node
};

/// `walk`: in postorder.
FilledRows filled_rows(const BlockPattern& pattern, const NodeGraph& graph, std::span<const int> walk,
                       const ChildLists& children) {
  FilledRows filled{.begin = std::vector<std::size_t>(walk.size()),
                    .count = std::vector<int>(walk.size()),
                    .unknowns = std::vector<int>(walk.size()),
                    .rows = {}};
  RowChain chain(pattern, filled);
  std::vector<char> is_done(walk.size(), 0);
  for (const int node : walk) {
    is_done[node] = 1;
    std::span<const int> others = children.of(node);
    if (!others.empty() && chain.go_on(node, others.back())) {
      others = others.first(others.size() - 1);
    } else {
      chain.begin(node);
    }
    for (const int other : graph.around(node)) {
      if (!is_done[other]) chain.add(other);
    }
    for (const int child : others) {
      const std::size_t end = filled.begin[child] + filled.count[child];
      for (std::size_t k = filled.begin[child]; k < end; ++k) chain.add(filled.rows[k]);
    }
    chain.end(node);
  }
  return filled;
}

}  // namespace

NodeTree make_node_tree(const BlockPattern& pattern, const NodeGraph& graph, std::span<const int> order,
                        const std::vector<int>& parent) {
  const std::size_t nodes = order.size();
  ChildLists children(order, parent);
  FilledRows filled = filled_rows(pattern, graph, postorder(order, parent, children), children);
  children.sort_by(filled.count);
  NodeTree tree{.node = postorder(order, parent, children),
                .place = std::vector<int>(nodes),
                .parent = std::vector<int>(nodes),
                .unknowns = std::vector<int>(nodes),
                .rows = std::vector<int>(nodes),
                .unknowns_below = std::vector<int>(nodes),
                .filled = std::move(filled)};
  for (std::size_t k = 0; k < nodes; ++k) tree.place[tree.node[k]] = static_cast<int>(k);
  for (std::size_t k = 0; k < nodes; ++k) {
    const int node = tree.node[k];
    tree.parent[k] = parent[node] < 0 ? -1 : tree.place[parent[node]];
    tree.unknowns[k] = pattern.unknowns_of(node);
    tree.rows[k] = tree.filled.count[node];
    tree.unknowns_below[k] = tree.filled.unknowns[node];
  }
  return tree;
}

}  // namespace thinwall
