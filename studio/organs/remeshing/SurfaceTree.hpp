#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "studio/organs/remeshing/TriangleSurface.hpp"

namespace thinwall {

struct NearestPoint {
  int triangle = -1;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // metres
  double distance = 0;                                 // metres
};

/// Finds the closest points of a surface through a tree of boxes.
class SurfaceTree {
 public:
  /// The surface must have triangles.
  explicit SurfaceTree(TriangleSurface surface);

  NearestPoint closest(const Eigen::Vector3d& point) const;

  /// The closest point of the triangles that face with `normal`, so that the far side of a thin body does not count; of
  /// all triangles where none does.
  NearestPoint closest_facing(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int begin = 0, end = 0;  // into order_
    int right = -1;          // the left child follows; no children at a leaf
  };

  void build(int begin, int end, const std::vector<Eigen::Vector3d>& middles);
  NearestPoint search(const Eigen::Vector3d& point, const Eigen::Vector3d* normal) const;

  TriangleSurface surface_;
  std::vector<Eigen::Vector3d> normals_;  // (triangles x 3), of any length
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace thinwall
