#include "engine/mesh/MeshMeasures.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

/// The three angles of a triangle, radians, by the arc tangent, which is exact for slivers where the arc cosine is not.
std::array<double, 3> angles_of(std::span<const Eigen::Vector3d> vertices, const Eigen::Vector3i& triangle) {
  std::array<double, 3> angles{};
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d a = vertices[triangle[(k + 1) % 3]] - vertices[triangle[k]];
    const Eigen::Vector3d b = vertices[triangle[(k + 2) % 3]] - vertices[triangle[k]];
    angles[k] = std::atan2(a.cross(b).norm(), a.dot(b));
  }
  return angles;
}

}  // namespace

Eigen::AlignedBox3d bounding_box(std::span<const Eigen::Vector3d> points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  return box;
}

std::vector<double> triangle_areas(std::span<const Eigen::Vector3d> vertices,
                                   std::span<const Eigen::Vector3i> triangles) {
  std::vector<double> areas;
  areas.reserve(triangles.size());
  for (const Eigen::Vector3i& t : triangles) {
    areas.push_back(0.5 * (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]).norm());
  }
  return areas;
}

double wall_area(const SurfaceMesh& mesh) {
  const std::vector<double> areas = triangle_areas(mesh.vertices, mesh.triangles);
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

double enclosed_volume(std::span<const Eigen::Vector3d> vertices, std::span<const Eigen::Vector3i> triangles) {
  if (triangles.empty()) return 0;
  const Eigen::Vector3d& origin = vertices[triangles.front()[0]];
  double six_volumes = 0;
  for (const Eigen::Vector3i& t : triangles) {
    six_volumes += (vertices[t[0]] - origin).dot((vertices[t[1]] - origin).cross(vertices[t[2]] - origin));
  }
  return six_volumes / 6;
}

double solid_angle(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& point) {
  const Eigen::Vector3d a = corners[0] - point, b = corners[1] - point, c = corners[2] - point;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

double enclosed_volume(const SurfaceMesh& mesh) {
  return enclosed_volume(mesh.vertices, closed_surface(mesh));
}

std::vector<double> smallest_angles(std::span<const Eigen::Vector3d> vertices,
                                    std::span<const Eigen::Vector3i> triangles) {
  std::vector<double> smallest;
  smallest.reserve(triangles.size());
  for (const Eigen::Vector3i& t : triangles) {
    const std::array<double, 3> angles = angles_of(vertices, t);
    smallest.push_back(*std::min_element(angles.begin(), angles.end()));
  }
  return smallest;
}

MeshQuality quality_of(const SurfaceMesh& mesh) {
  assert(!mesh.triangles.empty());
  MeshQuality quality;
  std::vector<double> smallest = smallest_angles(mesh.vertices, mesh.triangles);
  std::sort(smallest.begin(), smallest.end());
  quality.least_angle = smallest.front();
  quality.median_angle = smallest[smallest.size() / 2];
  for (const Eigen::Vector3i& t : mesh.triangles) {
    for (const double angle : angles_of(mesh.vertices, t)) {
      quality.largest_angle = std::max(quality.largest_angle, angle);
    }
  }
  const std::vector<double> areas = triangle_areas(mesh.vertices, mesh.triangles);
  quality.least_area = *std::min_element(areas.begin(), areas.end());
  quality.largest_area = *std::max_element(areas.begin(), areas.end());
  quality.mean_area = std::accumulate(areas.begin(), areas.end(), 0.0) / static_cast<double>(areas.size());
  return quality;
}

}  // namespace thinwall
