#include "engine/cutting/CarriedPoints.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "engine/contact/ClosestPoint.hpp"

namespace thinwall {
namespace {

std::array<Eigen::Vector3d, 3> corners_of(const SurfaceMesh& mesh, int triangle) {
  const Eigen::Vector3i& vertices = mesh.triangles[triangle];
  return {mesh.vertices[vertices[0]], mesh.vertices[vertices[1]], mesh.vertices[vertices[2]]};
}

/// Nearer than this to an edge, of the largest coordinate, a point lies on it: beside it, it would lie in one of its
/// triangles only.
constexpr double kOnEdge = 1e-12;

Eigen::Vector3d brought_to_edges(const std::array<Eigen::Vector3d, 3>& corners, Eigen::Vector3d weights) {
  double scale = 0;
  for (const Eigen::Vector3d& corner : corners) scale = std::max(scale, corner.cwiseAbs().maxCoeff());
  const double area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
  for (int k = 0; k < 3; ++k) {
    const double side = (corners[(k + 2) % 3] - corners[(k + 1) % 3]).norm();
    if (weights[k] * area <= kOnEdge * scale * side) weights[k] = 0;
  }
  return weights / weights.sum();
}

Eigen::Vector3d place_of(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& weights) {
  return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
}

}  // namespace

std::vector<SurfacePoint> carried_over(std::span<const SurfacePoint> points, const SurfaceMesh& before,
                                       const SurfaceMesh& after, const Cut& cut) {
  std::map<int, std::vector<int>> heirs;  // of a triangle before the cut, those that lie where it lay
  for (const TriangleSource& source : cut.triangles) {
    for (const TriangleShare& share : source.before) heirs[share.triangle].push_back(source.triangle);
  }
  std::vector<SurfacePoint> carried;
  for (const SurfacePoint& point : points) {
    const auto found = heirs.find(point.triangle);
    SurfacePoint best = point;
    if (found != heirs.end()) {
      const Eigen::Vector3d place = place_of(corners_of(before, point.triangle), point.weights);
      double nearest = std::numeric_limits<double>::infinity();
      for (const int triangle : found->second) {
        const std::array<Eigen::Vector3d, 3> corners = corners_of(after, triangle);
        const Eigen::Vector3d weights = closest_point(corners, place).weights;
        const double distance = (place_of(corners, weights) - place).norm();
        if (!(distance < nearest)) continue;
        nearest = distance;
        best = {.triangle = triangle, .weights = brought_to_edges(corners, weights)};
      }
    }
    carried.push_back(best);
  }
  return carried;
}

}  // namespace thinwall
