#include "engine/contact/PointRadius.hpp"

#include <cmath>
#include <numbers>

namespace thinwall {

double effective_point_radius(std::span<const Eigen::Vector3i> triangles, const Eigen::VectorXd& position,
                              const Eigen::Vector3i& vertices, const Eigen::Vector3d& weights) {
  double sum = 0, share = 0;
  for (const Eigen::Vector3i& triangle : triangles) {
    // Triangles around the point: those that have a vertex which bears it.
    double weight = 0;
    for (int k = 0; k < 3; ++k) weight += (triangle.array() == vertices[k]).any() ? weights[k] : 0;
    if (weight == 0) continue;
    double edges = 0;
    for (int k = 0; k < 3; ++k) {
      edges += (position.segment<3>(3 * triangle[k]) - position.segment<3>(3 * triangle[(k + 1) % 3])).norm() / 3;
    }
    sum += weight * edges;
    share += weight;
  }
  const double spread = weights[0] * weights[1] + weights[1] * weights[2] + weights[2] * weights[0];
  return sum / share * std::exp(2 * std::numbers::pi / std::numbers::sqrt3 * spread - std::numbers::egamma) /
         std::sqrt(12.0);
}

}  // namespace thinwall
