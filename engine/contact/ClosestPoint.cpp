#include "engine/contact/ClosestPoint.hpp"

#include <Eigen/Geometry>
#include <limits>

namespace thinwall {
namespace {

/// Closest point of an edge, at its ends included.
ClosestPoint on_edge(const std::array<Eigen::Vector3d, 3>& corners, int from, int to, const Eigen::Vector3d& point) {
  const Eigen::Vector3d edge = corners[to] - corners[from];
  const double along = edge.dot(point - corners[from]) / edge.squaredNorm();
  ClosestPoint closest;
  if (along <= 0 || along >= 1) {
    const int corner = along <= 0 ? from : to;
    closest.weights[corner] = 1;
    closest.corners[0] = corner;
    closest.corner_count = 1;
    return closest;
  }
  closest.weights[from] = 1 - along;
  closest.weights[to] = along;
  closest.corners = {from, to, 0};
  closest.corner_count = 2;
  return closest;
}

}  // namespace

ClosestPoint closest_point(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  ClosestPoint face{.weights = Eigen::Vector3d::Zero(), .corners = {0, 1, 2}, .corner_count = 3};
  bool inside = true;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d &next = corners[(k + 1) % 3], &last = corners[(k + 2) % 3];
    face.weights[k] = normal.dot((next - point).cross(last - point)) / normal.squaredNorm();
    inside = inside && face.weights[k] > 0;
  }
  if (inside) return face;
  ClosestPoint best;
  double smallest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const ClosestPoint candidate = on_edge(corners, k, (k + 1) % 3, point);
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    for (int c = 0; c < 3; ++c) position += candidate.weights[c] * corners[c];
    const double distance = (position - point).squaredNorm();
    if (distance < smallest) {
      smallest = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace thinwall
