#include "studio/organs/remeshing/SurfaceTree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "engine/contact/ClosestPoint.hpp"

namespace thinwall {
namespace {

constexpr int kTrianglesPerLeaf = 8;

}  // namespace

SurfaceTree::SurfaceTree(TriangleSurface surface) : surface_(std::move(surface)), order_(surface_.triangles.size()) {
  std::vector<Eigen::Vector3d> middles;
  for (const Eigen::Vector3i& t : surface_.triangles) {
    const Eigen::Vector3d& a = surface_.vertices[t[0]];
    const Eigen::Vector3d& b = surface_.vertices[t[1]];
    const Eigen::Vector3d& c = surface_.vertices[t[2]];
    middles.push_back((a + b + c) / 3);
    normals_.push_back((b - a).cross(c - a));
  }
  std::iota(order_.begin(), order_.end(), 0);
  build(0, static_cast<int>(order_.size()), middles);
}

void SurfaceTree::build(int begin, int end, const std::vector<Eigen::Vector3d>& middles) {
  const std::size_t here = nodes_.size();
  Node node{.box = {}, .begin = begin, .end = end};
  Eigen::AlignedBox3d spread;
  for (int i = begin; i < end; ++i) {
    for (const int v : surface_.triangles[order_[i]]) node.box.extend(surface_.vertices[v]);
    spread.extend(middles[order_[i]]);
  }
  nodes_.push_back(node);
  if (end - begin <= kTrianglesPerLeaf) return;
  int axis = 0;
  spread.sizes().maxCoeff(&axis);
  const int half = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                   [&](int s, int t) { return std::pair(middles[s][axis], s) < std::pair(middles[t][axis], t); });
  build(begin, half, middles);
  nodes_[here].right = static_cast<int>(nodes_.size());
  build(half, end, middles);
}

NearestPoint SurfaceTree::search(const Eigen::Vector3d& point, const Eigen::Vector3d* normal) const {
  NearestPoint best{.distance = std::numeric_limits<double>::infinity()};
  std::vector<int> open = {0};
  while (!open.empty()) {
    const int index = open.back();
    open.pop_back();
    const Node& node = nodes_[index];
    if (node.box.squaredExteriorDistance(point) > best.distance * best.distance) continue;
    if (node.right >= 0) {
      const int left = index + 1;
      const bool left_first =
          nodes_[left].box.squaredExteriorDistance(point) <= nodes_[node.right].box.squaredExteriorDistance(point);
      open.push_back(left_first ? node.right : left);
      open.push_back(left_first ? left : node.right);
      continue;
    }
    for (int i = node.begin; i < node.end; ++i) {
      const int t = order_[i];
      if (normal != nullptr && normals_[t].dot(*normal) <= 0) continue;
      std::array<Eigen::Vector3d, 3> corners;
      for (int k = 0; k < 3; ++k) corners[k] = surface_.vertices[surface_.triangles[t][k]];
      const Eigen::Vector3d weights = closest_point(corners, point).weights;
      const Eigen::Vector3d position = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
      const double distance = (position - point).norm();
      if (distance < best.distance || (distance == best.distance && t < best.triangle)) best = {t, position, distance};
    }
  }
  return best;
}

NearestPoint SurfaceTree::closest(const Eigen::Vector3d& point) const {
  return search(point, nullptr);
}

NearestPoint SurfaceTree::closest_facing(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const {
  const NearestPoint facing = search(point, &normal);
  return facing.triangle >= 0 ? facing : closest(point);
}

}  // namespace thinwall
