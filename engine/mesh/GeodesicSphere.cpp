#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "engine/mesh/ShapePatterns.hpp"
#include "engine/mesh/Shapes.hpp"

namespace thinwall {
namespace {

using std::numbers::pi;

/// Unit icosahedron with vertices 0 and 11 on the z axis.
std::array<Eigen::Vector3d, 12> icosahedron_vertices() {
  std::array<Eigen::Vector3d, 12> vertices;
  const double height = 1 / std::sqrt(5.0);
  const double reach = 2 / std::sqrt(5.0);
  vertices[0] = Eigen::Vector3d::UnitZ();
  vertices[11] = -Eigen::Vector3d::UnitZ();
  for (int k = 0; k < 5; ++k) {
    const double upper = 2 * pi * k / 5;
    const double lower = 2 * pi * (k + 0.5) / 5;
    vertices[1 + k] = {reach * std::cos(upper), reach * std::sin(upper), height};
    vertices[6 + k] = {reach * std::cos(lower), reach * std::sin(lower), -height};
  }
  return vertices;
}

std::array<Eigen::Vector3i, 20> icosahedron_faces() {
  std::array<Eigen::Vector3i, 20> faces;
  for (int k = 0; k < 5; ++k) {
    const int next = (k + 1) % 5;
    faces[4 * k] = {0, 1 + k, 1 + next};
    faces[4 * k + 1] = {1 + k, 6 + k, 1 + next};
    faces[4 * k + 2] = {1 + next, 6 + k, 6 + next};
    faces[4 * k + 3] = {11, 6 + next, 6 + k};
  }
  return faces;
}

/// Vertices named by their weights on the icosahedron's vertices, so faces share those on common edges.
class GeodesicVertices {
 public:
  GeodesicVertices(double radius, int segments) : radius_(radius), segments_(segments) {}

  int index_of(const Eigen::Vector3i& corners, const Eigen::Vector3i& weights) {
    std::map<int, int> key;
    for (int k = 0; k < 3; ++k) {
      if (weights[k] > 0) key[corners[k]] = weights[k];
    }
    const auto [entry, is_new] = indices_.try_emplace(key, static_cast<int>(vertices_.size()));
    if (is_new) vertices_.push_back(position_of(key));
    return entry->second;
  }
  std::vector<Eigen::Vector3d> take() { return std::move(vertices_); }

 private:
  /// Spherical interpolation extended to three corners: along the edges it gives equal arcs, and inside a face it keeps
  /// triangles nearer to equal than the projection of equal flat ones does.
  Eigen::Vector3d position_of(const std::map<int, int>& key) const {
    const double edge_angle = std::atan(2.0);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& [corner, weight] : key) sum += std::sin(edge_angle * weight / segments_) * corners_[corner];
    return radius_ * sum.normalized();
  }

  double radius_;
  int segments_;
  std::array<Eigen::Vector3d, 12> corners_ = icosahedron_vertices();
  std::map<std::map<int, int>, int> indices_;
  std::vector<Eigen::Vector3d> vertices_;
};

}  // namespace

SurfaceMesh make_sphere(double radius, int triangles) {
  assert(radius > 0);
  const int n = closest_square(triangles, 20);
  GeodesicVertices vertices(radius, n);
  SurfaceMesh mesh;
  for (const Eigen::Vector3i& face : icosahedron_faces()) {
    const auto vertex = [&](int i, int j) { return vertices.index_of(face, {n - i - j, i, j}); };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        mesh.triangles.emplace_back(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
        if (i + j + 2 <= n) mesh.triangles.emplace_back(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
    }
  }
  mesh.vertices = vertices.take();
  std::vector<int>& wall = mesh.groups["wall"];
  wall.resize(mesh.vertices.size());
  std::iota(wall.begin(), wall.end(), 0);
  return mesh;
}

}  // namespace thinwall
