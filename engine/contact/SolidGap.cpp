#include "engine/contact/SolidGap.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

/// A solid whose radius of curvature along an edge is more than this many edges counts as flat there.
constexpr double kFlat = 1e3;

Eigen::Matrix<double, 9, 9> hessian_of(const DeepestPoint& deepest, const SignedDistance& distance,
                                       const std::array<Eigen::Vector3d, 3>& corners, double crown) {
  Eigen::Matrix<double, 9, 9> hessian;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      hessian.block<3, 3>(3 * a, 3 * b) = deepest.weights[a] * deepest.weights[b] * distance.curvature;
    }
  }
  const int freedom = deepest.corner_count - 1;
  if (freedom == 0) return hessian;
  // A column that stays zero, along an edge the point may not leave, drops out below.
  Eigen::Matrix<double, 3, 2> edges = Eigen::Matrix<double, 3, 2>::Zero();
  Eigen::Matrix<double, 2, 9> coupling = Eigen::Matrix<double, 2, 9>::Zero();
  for (int k = 0; k < freedom; ++k) edges.col(k) = corners[deepest.corners[k + 1]] - corners[deepest.corners[0]];
  const Eigen::Matrix<double, 2, 3> bent = edges.transpose() * distance.curvature;
  for (int a = 0; a < 3; ++a) {
    for (int k = 0; k < freedom; ++k) {
      const double selected = a == deepest.corners[k + 1] ? 1 : (a == deepest.corners[0] ? -1 : 0);
      coupling.block<1, 3>(k, 3 * a) = deepest.weights[a] * bent.row(k) + selected * distance.normal.transpose();
    }
  }
  const Eigen::Matrix2d bending = bent * edges;                   // metres
  const double flat = edges.colwise().norm().maxCoeff() / kFlat;  // metres
  if (freedom == 1) {
    const double bend = bending(0, 0) + crown;
    if (crown > 0 || bend > flat) hessian -= coupling.row(0).transpose() * coupling.row(0) / bend;
    return hessian;
  }
  const double half_trace = 0.5 * bending.trace();
  const double smaller = half_trace - std::hypot(0.5 * (bending(0, 0) - bending(1, 1)), bending(0, 1));
  if (smaller > flat) {
    hessian -= coupling.transpose() * (bending.inverse() * coupling);
    return hessian;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> spectrum(bending);
  for (int k = 0; k < 2; ++k) {
    if (spectrum.eigenvalues()[k] <= flat) continue;
    const Eigen::Matrix<double, 1, 9> part = spectrum.eigenvectors().col(k).transpose() * coupling;
    hessian -= part.transpose() * part / spectrum.eigenvalues()[k];
  }
  return hessian;
}

DeepestPoint deepest_of(const ToolSolid& solid, const std::array<Eigen::Vector3d, 3>& corners, SitePart part,
                        int corner) {
  if (part == SitePart::kFace) return deepest_on_triangle(solid, corners);
  if (part == SitePart::kEdge) return deepest_on_edge(solid, corners, corner, (corner + 1) % 3);
  return {.weights = Eigen::Vector3d::Unit(corner), .corners = {corner, 0, 0}, .corner_count = 1};
}

}  // namespace

bool is_out_of_reach(const ToolSolid& solid, double reach, const std::array<Eigen::Vector3d, 3>& corners) {
  const Eigen::Vector3d centroid = (corners[0] + corners[1] + corners[2]) / 3;
  double extent = 0;
  for (const Eigen::Vector3d& corner : corners) extent = std::max(extent, (corner - centroid).squaredNorm());
  const double distance = solid.extent() + reach + std::sqrt(extent);
  return (centroid - solid.center).squaredNorm() > distance * distance;
}

std::optional<SolidGap> solid_gap(const ToolSolid& solid, double reach, const std::array<Eigen::Vector3d, 3>& corners,
                                  SitePart part, int corner, GapTerms wanted) {
  if (is_out_of_reach(solid, reach, corners)) return std::nullopt;
  const DeepestPoint deepest = deepest_of(solid, corners, part, corner);
  const SignedDistance distance = signed_distance(
      solid, deepest.weights[0] * corners[0] + deepest.weights[1] * corners[1] + deepest.weights[2] * corners[2]);
  if (distance.value >= reach) return std::nullopt;
  SolidGap result;
  result.gap = distance.value;
  if (solid.crown > 0 && part == SitePart::kEdge) {
    const double off_middle = deepest.weights[(corner + 1) % 3] - 0.5;
    result.gap += 0.5 * solid.crown * off_middle * off_middle;
  }
  result.normal = distance.normal;
  result.weights = deepest.weights;
  result.part = static_cast<SitePart>(deepest.corner_count - 1);
  for (int k = 0; k < 3; ++k) result.gradient.segment<3>(3 * k) = deepest.weights[k] * distance.normal;
  if (wanted == GapTerms::kHessian) {
    result.hessian = hessian_of(deepest, distance, corners, solid.crown);
  } else {
    result.hessian.setZero();
  }
  return result;
}

}  // namespace thinwall
