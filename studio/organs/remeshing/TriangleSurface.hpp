#pragma once

#include <Eigen/Core>
#include <vector>

namespace thinwall {

struct TriangleSurface {
  std::vector<Eigen::Vector3d> vertices;   // (vertices x 3), metres
  std::vector<Eigen::Vector3i> triangles;  // (triangles x 3), counter-clockwise seen from outside
};

}  // namespace thinwall
