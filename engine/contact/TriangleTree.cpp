#include "engine/contact/TriangleTree.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

namespace thinwall {
namespace {

Eigen::AlignedBox3d box_of(const Eigen::Vector3i& triangle, const Eigen::VectorXd& vectors) {
  Eigen::AlignedBox3d box;
  for (const int vertex : triangle) box.extend(vectors.segment<3>(3 * vertex));
  return box;
}

}  // namespace

TriangleTree::TriangleTree(std::span<const Eigen::Vector3i> triangles, const Eigen::VectorXd& position,
                           std::span<const double> margins)
    : triangles_(triangles.begin(), triangles.end()) {
  build(position);
  measure(position, margins);
}

TriangleTree::TriangleTree(std::span<const Eigen::Vector3i> triangles, const Eigen::VectorXd& position,
                           std::span<const double> margins, const TriangleTree& before)
    : triangles_(triangles.begin(), triangles.end()) {
  assert(triangles_.size() >= before.triangles_.size());
  if (4 * triangles_.size() > 5 * before.built_count_) {
    build(position);
  } else {
    nodes_ = before.nodes_;
    leaf_of_ = before.leaf_of_;
    built_count_ = before.built_count_;
    put_in_further(before.triangles_.size(), static_cast<std::size_t>(position.size() / 3));
  }
  measure(position, margins);
}

void TriangleTree::measure(const Eigen::VectorXd& position, std::span<const double> margins) {
  boxes_.resize(nodes_.size());
  fit(position);
  rest_boxes_ = boxes_;
  margins_.resize(nodes_.size());
  marked_.assign(nodes_.size(), 1);
  for (int k = static_cast<int>(nodes_.size()) - 1; k >= 0; --k) {
    const Node& node = nodes_[k];
    if (node.left >= 0) {
      margins_[k] = std::max(margins_[node.left], margins_[node.right]);
    } else {
      for (const int vertex : triangles_[node.triangle]) margins_[k] = std::max(margins_[k], margins[vertex]);
    }
  }
}

void TriangleTree::build(const Eigen::VectorXd& position) {
  std::vector<Leaf> leaves;
  leaves.reserve(triangles_.size());
  nodes_.reserve(2 * triangles_.size());
  for (const Eigen::Vector3i& triangle : triangles_) {
    leaves.push_back({.center = box_of(triangle, position).center(), .triangle = static_cast<int>(leaves.size())});
  }
  leaf_of_.resize(triangles_.size());
  built_count_ = triangles_.size();
  if (!leaves.empty()) build(leaves);
}

int TriangleTree::build(std::span<Leaf> leaves) {
  const int node = static_cast<int>(nodes_.size());
  nodes_.push_back({.size = static_cast<int>(leaves.size())});
  if (leaves.size() == 1) {
    nodes_[node].triangle = leaves.front().triangle;
    leaf_of_[leaves.front().triangle] = node;
    return node;
  }
  Eigen::AlignedBox3d spread;
  for (const Leaf& leaf : leaves) spread.extend(leaf.center);
  Eigen::Index axis;
  spread.sizes().maxCoeff(&axis);
  const std::size_t middle = leaves.size() / 2;
  std::nth_element(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(middle), leaves.end(),
                   [&](const Leaf& a, const Leaf& b) {
                     return std::pair(a.center[axis], a.triangle) < std::pair(b.center[axis], b.triangle);
                   });
  const int left = build(leaves.first(middle)), right = build(leaves.subspan(middle));
  nodes_[node].left = left;
  nodes_[node].right = right;
  return node;
}

/// In place of the neighbour's leaf: a node with both.
void TriangleTree::put_in(int triangle, int neighbour) {
  const int leaf = leaf_of_[neighbour], moved = static_cast<int>(nodes_.size());
  nodes_.push_back({.triangle = neighbour});
  nodes_.push_back({.triangle = triangle});
  nodes_[leaf] = {.left = moved, .right = moved + 1};
  leaf_of_[neighbour] = moved;
  leaf_of_.push_back(moved + 1);
}

void TriangleTree::put_in_further(std::size_t known, std::size_t vertices) {
  std::vector<char> is_asked(vertices, 0);
  for (std::size_t t = known; t < triangles_.size(); ++t) {
    for (const int vertex : triangles_[t]) is_asked[vertex] = 1;
  }
  std::vector<int> at(vertices, -1);  // the first triangle at each vertex that is asked for
  const auto enter = [&](std::size_t t) {
    for (const int vertex : triangles_[t]) {
      if (is_asked[vertex] && at[vertex] < 0) at[vertex] = static_cast<int>(t);
    }
  };
  for (std::size_t t = 0; t < known; ++t) enter(t);
  for (std::size_t t = known; t < triangles_.size(); ++t) {
    int neighbour = 0;
    for (const int vertex : triangles_[t]) neighbour = std::max(neighbour, at[vertex]);
    put_in(static_cast<int>(t), neighbour);
    enter(t);
  }
  for (int k = static_cast<int>(nodes_.size()) - 1; k >= 0; --k) {
    Node& node = nodes_[k];
    if (node.left >= 0) node.size = nodes_[node.left].size + nodes_[node.right].size;
  }
}

void TriangleTree::mark(std::span<const char> vertices) {
  for (int k = static_cast<int>(nodes_.size()) - 1; k >= 0; --k) {
    const Node& node = nodes_[k];
    if (node.left >= 0) {
      marked_[k] = marked_[node.left] || marked_[node.right];
    } else {
      const Eigen::Vector3i& corners = triangles_[node.triangle];
      marked_[k] = vertices[corners[0]] || vertices[corners[1]] || vertices[corners[2]];
    }
  }
}

void TriangleTree::fit(const Eigen::VectorXd& position) {
  for (int k = static_cast<int>(nodes_.size()) - 1; k >= 0; --k) {
    const Node& node = nodes_[k];
    boxes_[k] =
        node.left < 0 ? box_of(triangles_[node.triangle], position) : boxes_[node.left].merged(boxes_[node.right]);
  }
}

void TriangleTree::fit(const Eigen::VectorXd& position, const Eigen::VectorXd& motion) {
  fit(position);
  motions_.resize(nodes_.size());
  for (int k = static_cast<int>(nodes_.size()) - 1; k >= 0; --k) {
    const Node& node = nodes_[k];
    motions_[k] =
        node.left < 0 ? box_of(triangles_[node.triangle], motion) : motions_[node.left].merged(motions_[node.right]);
  }
}

double TriangleTree::squared_travel(int a, int b) const {
  const Eigen::Vector3d one = motions_[a].max() - motions_[b].min(), other = motions_[b].max() - motions_[a].min();
  return one.cwiseAbs().cwiseMax(other.cwiseAbs()).squaredNorm();
}

bool TriangleTree::stays_apart(int a, int b, double kept) const {
  const auto least_gap = [&](int below, int above) {
    const Eigen::Vector3d begin = boxes_[above].min() - boxes_[below].max();
    const Eigen::Vector3d end = begin + motions_[above].min() - motions_[below].max();
    return begin.cwiseMin(end).maxCoeff();
  };
  const double gap = std::max(least_gap(a, b), least_gap(b, a));
  return gap > 0 && gap > kept * boxes_[a].merged(boxes_[b]).diagonal().norm();
}

}  // namespace thinwall
