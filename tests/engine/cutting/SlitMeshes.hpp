#pragma once

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/mesh/Shapes.hpp"

namespace thinwall {

inline void add_mesh(const SurfaceMesh& more, SurfaceMesh& mesh) {
  const int shift = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const Eigen::Vector3i& triangle : more.triangles) mesh.triangles.push_back(triangle.array() + shift);
}

/// Doubles the vertices with x = 0 for which `inside` holds and moves the two apart, by `gape(vertex)` along x.
template <typename Inside, typename Gape>
SurfaceMesh slit(SurfaceMesh mesh, const Inside& inside, const Gape& gape) {
  std::map<int, int> doubles;
  const std::vector<Eigen::Vector3d> before = mesh.vertices;
  for (int v = 0; v < static_cast<int>(before.size()); ++v) {
    if (std::abs(before[v].x()) > 1e-12 || !inside(before[v])) continue;
    doubles[v] = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(before[v]);
    mesh.vertices.back().x() += 0.5 * gape(before[v]);
    mesh.vertices[v].x() -= 0.5 * gape(before[v]);
  }
  for (Eigen::Vector3i& triangle : mesh.triangles) {
    const double middle = (before[triangle[0]].x() + before[triangle[1]].x() + before[triangle[2]].x()) / 3;
    for (int& vertex : triangle) {
      if (middle > 0 && doubles.contains(vertex)) vertex = doubles[vertex];
    }
  }
  return mesh;
}

/// A sheet of 40 mm with a slit along y, 20 mm long, whose lips are `gape` apart in the middle; `bent` along x to a
/// quarter of a tube.
inline SurfaceMesh slit_sheet(double gape, bool bent = false) {
  SurfaceMesh mesh = slit(
      make_sheet(0.04, 0.04, 400), [](const Eigen::Vector3d& v) { return std::abs(v.y()) < 0.0099; },
      [gape](const Eigen::Vector3d& v) { return gape * std::sqrt(1 - v.y() * v.y() / 1e-4); });
  for (Eigen::Vector3d& v : mesh.vertices) {
    const double angle = v.x() / 0.025;
    if (bent) v = Eigen::Vector3d(0.025 * std::sin(angle), v.y(), 0.025 * (std::cos(angle) - 1));
  }
  return mesh;
}

/// A sphere of 20 mm with a slit through its pole, 20 mm long, in the plane x = 0.
inline SurfaceMesh slit_sphere(double gape) {
  return slit(
      make_sphere(0.02, 1280), [](const Eigen::Vector3d& v) { return std::abs(v.y()) < 0.0099 && v.z() > 0; },
      [gape](const Eigen::Vector3d& v) { return gape * std::sqrt(1 - v.y() * v.y() / 1e-4); });
}

}  // namespace thinwall
