#include "engine/contact/FoldPotential.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace thinwall {
namespace {

/// Part of its range below which a pair is crushed: its curvature along the wall, force over distance, is then far
/// above what the wall itself has, and a step that does not know of it seems to lead apart and leads into each other.
constexpr double kCrushed = 1e-2;

/// The factor that fades out parallel edges and crushed triangles, by the squared cross product of the edges.
struct Mollifier {
  double factor = 1, slope = 0, curvature = 0;
};

/// The two edges, or two sides of the triangle, each from its first corner to its second.
struct PairEdges {
  std::array<int, 2> first, second;
};

PairEdges edges_of(PairKind kind) {
  if (kind == PairKind::kEdgeEdge) return {.first = {0, 1}, .second = {2, 3}};
  return {.first = {1, 2}, .second = {1, 3}};
}

Eigen::Vector3d edge_at(const std::array<int, 2>& edge, const PairCorners& corners) {
  return corners[edge[1]] - corners[edge[0]];
}

double squared_cross(PairKind kind, const PairCorners& corners) {
  const PairEdges edges = edges_of(kind);
  const Eigen::Vector3d u = edge_at(edges.first, corners), v = edge_at(edges.second, corners);
  const double uv = u.dot(v);
  return u.squaredNorm() * v.squaredNorm() - uv * uv;
}

Mollifier mollifier(const FoldPair& pair) {
  if (pair.parallel == 0) return {};
  const double ratio = squared_cross(pair.kind, pair.corners) / pair.parallel;
  if (ratio >= 1) return {};
  return {.factor = (2 - ratio) * ratio,
          .slope = 2 * (1 - ratio) / pair.parallel,
          .curvature = -2 / (pair.parallel * pair.parallel)};
}

/// Spreads derivatives by the two edges over the four corners.
Eigen::Matrix<double, 12, 6> edges_by_corners(PairKind kind) {
  const PairEdges edges = edges_of(kind);
  Eigen::Matrix<double, 12, 6> spread = Eigen::Matrix<double, 12, 6>::Zero();
  for (int k = 0; k < 3; ++k) {
    spread(3 * edges.first[0] + k, k) = spread(3 * edges.second[0] + k, 3 + k) = -1;
    spread(3 * edges.first[1] + k, k) = spread(3 * edges.second[1] + k, 3 + k) = 1;
  }
  return spread;
}

Eigen::Matrix<double, 12, 1> cross_gradient(PairKind kind, const PairCorners& corners) {
  const PairEdges edges = edges_of(kind);
  const Eigen::Vector3d u = edge_at(edges.first, corners), v = edge_at(edges.second, corners);
  Eigen::Matrix<double, 6, 1> by_edges;
  by_edges << 2 * (v.squaredNorm() * u - u.dot(v) * v), 2 * (u.squaredNorm() * v - u.dot(v) * u);
  return edges_by_corners(kind) * by_edges;
}

Eigen::Matrix<double, 12, 12> cross_hessian(PairKind kind, const PairCorners& corners) {
  const PairEdges edges = edges_of(kind);
  const Eigen::Vector3d u = edge_at(edges.first, corners), v = edge_at(edges.second, corners);
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  Eigen::Matrix<double, 6, 6> by_edges;
  by_edges.topLeftCorner<3, 3>() = 2 * (v.squaredNorm() * identity - v * v.transpose());
  by_edges.bottomRightCorner<3, 3>() = 2 * (u.squaredNorm() * identity - u * u.transpose());
  by_edges.topRightCorner<3, 3>() = 4 * u * v.transpose() - 2 * v * u.transpose() - 2 * u.dot(v) * identity;
  by_edges.bottomLeftCorner<3, 3>() = by_edges.topRightCorner<3, 3>().transpose();
  const Eigen::Matrix<double, 12, 6> spread = edges_by_corners(kind);
  return spread * by_edges * spread.transpose();
}

}  // namespace

DistanceTerms FoldPotential::at(double distance) const {
  const double x = distance / range;
  if (x >= 1) return {};
  const double logarithm = std::log(x), open = 1 - x, force = pressure * area;
  return {.energy = -force * range * open * open * logarithm,
          .slope = force * (2 * open * logarithm - open * open / x),
          .curvature = force / range * (-2 * logarithm + 4 * open / x + open * open / (x * x))};
}

FoldTerms FoldPair::terms() const {
  const DistanceTerms barrier = potential.at(closest.distance);
  const Mollifier fade = mollifier(*this);
  FoldTerms result{.energy = fade.factor * barrier.energy,
                   .gradient = fade.factor * barrier.slope * distance_gradient(closest)};
  if (fade.slope != 0) result.gradient += fade.slope * barrier.energy * cross_gradient(kind, corners);
  return result;
}

Eigen::Matrix<double, 12, 12> FoldPair::hessian() const {
  const DistanceTerms barrier = potential.at(closest.distance);
  const Mollifier fade = mollifier(*this);
  const Eigen::Matrix<double, 12, 1> approach = distance_gradient(closest);
  Eigen::Matrix<double, 12, 12> result = fade.factor * (barrier.curvature * approach * approach.transpose() +
                                                        barrier.slope * distance_hessian(closest, corners));
  if (fade.slope == 0) return result;
  const Eigen::Matrix<double, 12, 1> turn = cross_gradient(kind, corners);
  result += barrier.energy * (fade.curvature * turn * turn.transpose() + fade.slope * cross_hessian(kind, corners));
  const Eigen::Matrix<double, 12, 12> mixed = fade.slope * barrier.slope * turn * approach.transpose();
  result += mixed + mixed.transpose();
  return result;
}

Eigen::Matrix<double, 12, 12> FoldPair::convex_hessian() const {
  if (closest.distance > kCrushed * potential.range) {
    const Eigen::Matrix<double, 12, 1> approach = distance_gradient(closest);
    return mollifier(*this).factor * potential.at(closest.distance).curvature * approach * approach.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 12, 12>> parts(hessian());
  const Eigen::Matrix<double, 12, 1> curvatures = parts.eigenvalues().cwiseMax(0.0);
  return parts.eigenvectors() * curvatures.asDiagonal() * parts.eigenvectors().transpose();
}

std::optional<FoldPair> fold_of(const NearPair& near, const Eigen::VectorXd& position, double pressure) {
  const PairCorners corners = corners_at(near.vertices, position);
  if (least_distance(near.kind, corners) >= near.range) return {};
  const PairDistance closest = pair_distance(near.kind, corners);
  if (closest.distance >= near.range) return {};
  return FoldPair{.kind = near.kind,
                  .corners = corners,
                  .closest = closest,
                  .potential = {.range = near.range, .pressure = pressure, .area = near.area},
                  .parallel = near.parallel};
}

double parallel_bound(PairKind kind, const PairCorners& rest_corners) {
  const PairEdges edges = edges_of(kind);
  return 1e-3 * edge_at(edges.first, rest_corners).squaredNorm() * edge_at(edges.second, rest_corners).squaredNorm();
}

}  // namespace thinwall
