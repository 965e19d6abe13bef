#include "studio/organs/remeshing/MeshRemeshing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "studio/organs/remeshing/Remeshing.hpp"
#include "studio/organs/remeshing/SurfaceTree.hpp"

namespace thinwall {
namespace {

constexpr double kCreaseAngle = 50 * std::numbers::pi / 180;  // radians

/// Of the wanted edge length.
constexpr double kShortestCrease = 2;

/// Corners, and the middles of edges and triangles.
std::vector<Eigen::Vector3d> samples_of(const TriangleSurface& surface) {
  std::vector<Eigen::Vector3d> samples = surface.vertices;
  for (const Eigen::Vector3i& t : surface.triangles) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      sum += surface.vertices[t[k]];
      samples.push_back((surface.vertices[t[k]] + surface.vertices[t[(k + 1) % 3]]) / 2);
    }
    samples.push_back(sum / 3);
  }
  return samples;
}

double largest_distance(const TriangleSurface& from, const SurfaceTree& to) {
  double largest = 0;
  for (const Eigen::Vector3d& point : samples_of(from)) largest = std::max(largest, to.closest(point).distance);
  return largest;
}

}  // namespace

RemeshedMesh remesh_to_length(const TriangleSurface& start, double edge_length) {
  const SurfaceTree tree(start);
  const SurfaceToFollow target{
      .project = [&](const Eigen::Vector3d& point,
                     const Eigen::Vector3d& normal) { return tree.closest_facing(point, normal).position; },
      .normal = [](const Eigen::Vector3d&, const Eigen::Vector3d& normal) { return normal; }};
  RemeshedMesh result;
  result.surface = remesh(
      start, target,
      {.edge_length = edge_length, .features = FeatureLines(start, kCreaseAngle, kShortestCrease * edge_length)});
  for (const Eigen::Vector3i& t : result.surface.triangles) {
    const Eigen::Vector3d& a = result.surface.vertices[t[0]];
    const Eigen::Vector3d& b = result.surface.vertices[t[1]];
    const Eigen::Vector3d& c = result.surface.vertices[t[2]];
    result.source.push_back(tree.closest_facing((a + b + c) / 3, (b - a).cross(c - a)).triangle);
  }
  result.largest_distance =
      std::max(largest_distance(result.surface, tree), largest_distance(start, SurfaceTree(result.surface)));
  return result;
}

}  // namespace thinwall
