#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

namespace thinwall {

/// Boxes around the triangles of a moving surface, nested by a binary tree that is built once: triangles that lie
/// beside each other in the stress-free shape stay so. Pairs of triangles come in an order that the shape of the tree
/// alone determines, so that sums over near pairs are the same whatever is left out.
class TriangleTree {
 public:
  /// `position`: (3 vertices), metres, of the stress-free shape.
  TriangleTree(std::span<const Eigen::Vector3i> triangles, const Eigen::VectorXd& position);

  /// Fits the boxes to where the vertices are, and to how they move (metres, from there).
  void fit(const Eigen::VectorXd& position);
  void fit(const Eigen::VectorXd& position, const Eigen::VectorXd& motion);

  /// Calls visit(triangle, other) for all pairs of triangles, whose boxes lie within `reach` of each other, metres.
  template <typename Visit>
  void visit_near(double reach, const Visit& visit) const {
    visit_pairs([&](int a, int b) { return boxes_[a].squaredExteriorDistance(boxes_[b]) <= reach * reach; }, visit);
  }

  /// The same for pairs whose boxes may meet during the motion.
  template <typename Visit>
  void visit_meeting(const Visit& visit) const {
    visit_pairs([&](int a, int b) { return boxes_[a].squaredExteriorDistance(boxes_[b]) <= squared_travel(a, b); },
                visit);
  }

 private:
  struct Node {
    int left = -1, right = -1;  // nodes; none at a leaf
    int triangle = -1;          // at a leaf
    int size = 1;               // triangles below
  };

  int build(std::vector<int>& order, int begin, int end, const std::vector<Eigen::Vector3d>& centers);
  double squared_travel(int a, int b) const;

  template <typename Near, typename Visit>
  void visit_pairs(const Near& near, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::vector<std::array<int, 2>> open = {{0, 0}};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      const Node &first = nodes_[a], &second = nodes_[b];
      if (a == b) {
        if (first.left < 0) continue;
        open.push_back({first.left, first.left});
        open.push_back({first.right, first.right});
        open.push_back({first.left, first.right});
      } else if (near(a, b)) {
        if (first.left < 0 && second.left < 0) {
          visit(first.triangle, second.triangle);
        } else if (first.size >= second.size) {
          open.push_back({first.left, b});
          open.push_back({first.right, b});
        } else {
          open.push_back({a, second.left});
          open.push_back({a, second.right});
        }
      }
    }
  }

  std::vector<Eigen::Vector3i> triangles_;
  std::vector<Node> nodes_;  // parents before their children
  std::vector<Eigen::AlignedBox3d> boxes_, motions_;
};

}  // namespace thinwall
