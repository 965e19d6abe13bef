#pragma once

#include <tbb/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace thinwall {

/// Boxes around the triangles of a moving surface, nested by a binary tree that is built once: triangles that lie
/// beside each other in the stress-free shape stay so. Pairs of triangles come in an order that the shape of the tree
/// alone determines.
class TriangleTree {
 public:
  TriangleTree() = default;

  /// `position`: (3 vertices), metres, of the stress-free shape. `margins`: (vertices), metres.
  TriangleTree(std::span<const Eigen::Vector3i> triangles, const Eigen::VectorXd& position,
               std::span<const double> margins);

  /// The same for a surface that has changed since `before` was built, whose triangles come first: each keeps its place
  /// in the tree, and further ones are put beside one that they share a vertex with. Built anew once their number has
  /// grown by a quarter. The pairs come in another order then.
  TriangleTree(std::span<const Eigen::Vector3i> triangles, const Eigen::VectorXd& position,
               std::span<const double> margins, const TriangleTree& before);

  /// Fits the boxes to where the vertices are, and to how they move (metres, from there).
  void fit(const Eigen::VectorXd& position);
  void fit(const Eigen::VectorXd& position, const Eigen::VectorXd& motion);

  /// From now on pairs of which neither triangle has a marked vertex are left out. At first all are.
  /// `vertices`: whether each is marked.
  void mark(std::span<const char> vertices);

  /// Calls visit(task, triangle, other, reach) for all pairs of triangles, one of them marked, whose boxes lie within
  /// reach of each other, metres: the margins of both and `range`, or `rest_part` of what they can lie apart in the
  /// stress-free shape where that is less. So triangles that are small in comparison with the range do not all meet
  /// each other. The pairs are shared out in tasks as the tree alone determines, and each task is done by one thread;
  /// begin(tasks) is called before.
  template <typename Begin, typename Visit>
  void visit_near(double range, double rest_part, const Begin& begin, const Visit& visit) const {
    const auto reach = [&](int a, int b) {
      const double apart = rest_boxes_[a].merged(rest_boxes_[b]).diagonal().norm();
      return std::min(range, rest_part * apart) + margins_[a] + margins_[b];
    };
    const auto near = [&](int a, int b) {
      if (!marked_[a] && !marked_[b]) return false;
      const double distance = boxes_[a].squaredExteriorDistance(boxes_[b]);
      const double farthest = range + margins_[a] + margins_[b];
      if (distance == 0 || distance > farthest * farthest) return distance == 0;
      const double within = reach(a, b);
      return distance <= within * within;
    };
    visit_pairs(near, begin, [&](std::size_t task, int a, int b) {
      visit(task, nodes_[a].triangle, nodes_[b].triangle, reach(a, b));
    });
  }

  /// The same for pairs, one of them marked, whose boxes may come closer during the motion than a part `kept` of how
  /// far what is in them lies apart, without a reach.
  template <typename Begin, typename Visit>
  void visit_meeting(double kept, const Begin& begin, const Visit& visit) const {
    const auto may_meet = [&](int a, int b) {
      if (!marked_[a] && !marked_[b]) return false;
      return boxes_[a].squaredExteriorDistance(boxes_[b]) <= squared_travel(a, b) && !stays_apart(a, b, kept);
    };
    visit_pairs(may_meet, begin,
                [&](std::size_t task, int a, int b) { visit(task, nodes_[a].triangle, nodes_[b].triangle); });
  }

 private:
  struct Leaf {
    Eigen::Vector3d center;  // metres, of its box in the stress-free shape
    int triangle = 0;
  };
  struct Node {
    int left = -1, right = -1;  // nodes; none at a leaf
    int triangle = -1;          // at a leaf
    int size = 1;               // triangles below
  };

  void build(const Eigen::VectorXd& position);
  int build(std::span<Leaf> leaves);
  void put_in(int triangle, int neighbour);
  void put_in_further(std::size_t known, std::size_t vertices);
  void measure(const Eigen::VectorXd& position, std::span<const double> margins);
  double squared_travel(int a, int b) const;
  /// Whether a gap along an axis is there from the beginning of the motion to its end: so it is between the opposite
  /// sides of a body that grows, far as these may travel.
  bool stays_apart(int a, int b, double kept) const;

  /// Two nodes, or one with itself: all pairs of the triangles below.
  using NodePair = std::array<int, 2>;

  /// Triangles from which on the pairs are shared out, and about how many tasks there are then.
  static constexpr std::size_t kWorthSharing = 1000;
  static constexpr std::size_t kTasks = 64;

  static bool are_leaves(const Node& first, const Node& second) { return first.left < 0 && second.left < 0; }

  /// Adds the pairs of what lies below one step to those that are open; nothing where it is not near.
  template <typename Near>
  void open_pair(const NodePair& pair, const Near& near, std::vector<NodePair>& open) const {
    const auto [a, b] = pair;
    const Node &first = nodes_[a], &second = nodes_[b];
    if (!near(a, b)) return;
    if (a == b) {
      open.insert(open.end(), {{first.left, first.left}, {first.right, first.right}, {first.left, first.right}});
    } else if (first.size >= second.size) {
      open.insert(open.end(), {{first.left, b}, {first.right, b}});
    } else {
      open.insert(open.end(), {{a, second.left}, {a, second.right}});
    }
  }

  /// Calls visit(a, b) for all near pairs of different leaves below.
  template <typename Near, typename Visit>
  void visit_below(const NodePair& pair, const Near& near, const Visit& visit) const {
    std::vector<NodePair> open = {pair};
    while (!open.empty()) {
      const NodePair next = open.back();
      open.pop_back();
      if (!are_leaves(nodes_[next[0]], nodes_[next[1]])) {
        open_pair(next, near, open);
      } else if (next[0] != next[1] && near(next[0], next[1])) {
        visit(next[0], next[1]);
      }
    }
  }

  template <typename Near, typename Begin, typename Visit>
  void visit_pairs(const Near& near, const Begin& begin, const Visit& visit) const {
    std::vector<NodePair> tasks;
    if (!nodes_.empty()) tasks.push_back({0, 0});
    const std::size_t wanted = triangles_.size() < kWorthSharing ? 1 : kTasks;
    std::size_t opened = 0;
    for (; opened < tasks.size() && tasks.size() - opened < wanted; ++opened) {
      const NodePair pair = tasks[opened];
      if (are_leaves(nodes_[pair[0]], nodes_[pair[1]])) break;
      open_pair(pair, near, tasks);
    }
    const std::size_t count = tasks.size() - opened;
    begin(count);
    const auto visit_task = [&](std::size_t task) {
      visit_below(tasks[opened + task], near, [&](int a, int b) { visit(task, a, b); });
    };
    if (count == 1) {
      visit_task(0);
    } else {
      tbb::parallel_for(std::size_t{0}, count, visit_task);
    }
  }

  std::vector<Eigen::Vector3i> triangles_;
  std::vector<Node> nodes_;      // parents before their children
  std::vector<int> leaf_of_;     // (triangles), nodes
  std::size_t built_count_ = 0;  // triangles when the tree was built
  std::vector<Eigen::AlignedBox3d> boxes_, rest_boxes_;
  std::vector<Eigen::AlignedBox3d> motions_;  // empty until a motion is asked for
  std::vector<double> margins_;               // (nodes), metres, largest of the vertices below
  std::vector<char> marked_;                  // (nodes), whether a vertex below is
};

}  // namespace thinwall
