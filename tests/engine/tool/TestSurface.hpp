#pragma once

#include <Eigen/Core>
#include <utility>

#include "engine/mesh/SurfaceMesh.hpp"
#include "engine/tool/FirstContact.hpp"

namespace thinwall {

inline const Eigen::Vector3d kDown(0, 0, -1);

/// A mesh in the form in which tools look at it.
class TestSurface {
 public:
  explicit TestSurface(SurfaceMesh mesh, bool open = false) : mesh_(std::move(mesh)), open_(open) {
    position_.resize(static_cast<Eigen::Index>(3 * mesh_.vertices.size()));
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
      position_.segment<3>(static_cast<Eigen::Index>(3 * v)) = mesh_.vertices[v];
    }
  }

  SurfaceView view() const { return {.triangles = mesh_.triangles, .position = position_, .open = open_}; }

  Eigen::Vector3d point(int triangle, const Eigen::Vector3d& weights) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) sum += weights[k] * mesh_.vertices[mesh_.triangles[triangle][k]];
    return sum;
  }

 private:
  SurfaceMesh mesh_;
  Eigen::VectorXd position_;
  bool open_;
};

/// The cube [0, 1]^3, outward.
inline SurfaceMesh unit_cube() {
  SurfaceMesh cube;
  for (int k = 0; k < 8; ++k) cube.vertices.emplace_back(k & 1, (k >> 1) & 1, (k >> 2) & 1);
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return cube;
}

}  // namespace thinwall
