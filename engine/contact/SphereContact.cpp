#include "engine/contact/SphereContact.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/contact/ClosestPoint.hpp"

namespace thinwall {

double ContactPotential::energy(double gap) const {
  const double closed = std::max(0.0, range - gap);
  return 0.5 * stiffness() * closed * closed;
}

namespace {

bool out_of_reach(const SphereTool& sphere, double reach, const std::array<Eigen::Vector3d, 3>& corners) {
  const Eigen::Vector3d centroid = (corners[0] + corners[1] + corners[2]) / 3;
  double extent = 0;
  for (const Eigen::Vector3d& corner : corners) extent = std::max(extent, (corner - centroid).squaredNorm());
  const double distance = sphere.radius + reach + std::sqrt(extent);
  return (centroid - sphere.center).squaredNorm() > distance * distance;
}

/// Hessian of half the squared distance to the closest point; see the header.
Eigen::Matrix<double, 9, 9> half_square_hessian(const ClosestPoint& closest, const Eigen::Vector3d& offset,
                                                const std::array<Eigen::Vector3d, 3>& corners) {
  Eigen::Matrix<double, 9, 9> hessian;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      hessian.block<3, 3>(3 * a, 3 * b) = closest.weights[a] * closest.weights[b] * Eigen::Matrix3d::Identity();
    }
  }
  const int freedom = closest.corner_count - 1;
  if (freedom == 0) return hessian;
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 2> edges(3, freedom);
  Eigen::Matrix<double, Eigen::Dynamic, 9, 0, 2, 9> coupling(freedom, 9);
  for (int k = 0; k < freedom; ++k) edges.col(k) = corners[closest.corners[k + 1]] - corners[closest.corners[0]];
  for (int a = 0; a < 3; ++a) {
    for (int k = 0; k < freedom; ++k) {
      const double selected = a == closest.corners[k + 1] ? 1 : (a == closest.corners[0] ? -1 : 0);
      coupling.block<1, 3>(k, 3 * a) = closest.weights[a] * edges.col(k).transpose() + selected * offset.transpose();
    }
  }
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2> metric = edges.transpose() * edges;
  hessian -= coupling.transpose() * metric.inverse() * coupling;
  return hessian;
}

}  // namespace

std::optional<SphereGap> sphere_gap(const SphereTool& sphere, double reach,
                                    const std::array<Eigen::Vector3d, 3>& corners) {
  if (out_of_reach(sphere, reach, corners)) return std::nullopt;
  const ClosestPoint closest = closest_point(corners, sphere.center);
  Eigen::Vector3d offset = -sphere.center;
  for (int k = 0; k < 3; ++k) offset += closest.weights[k] * corners[k];
  const double distance = offset.norm();
  SphereGap result;
  result.gap = distance - sphere.radius;
  if (result.gap >= reach) return std::nullopt;
  result.normal = offset / distance;
  for (int k = 0; k < 3; ++k) result.gradient.segment<3>(3 * k) = closest.weights[k] * result.normal;
  result.hessian =
      (half_square_hessian(closest, offset, corners) - result.gradient * result.gradient.transpose()) / distance;
  return result;
}

}  // namespace thinwall
