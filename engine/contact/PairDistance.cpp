#include "engine/contact/PairDistance.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/contact/ClosestPoint.hpp"

namespace thinwall {
namespace {

/// Metres; keeps a quotient a number where both centres are the same.
constexpr double kSmallestLength = 1e-300;

void measure(const PairCorners& corners, PairDistance& closest) {
  closest.offset.setZero();
  for (int k = 0; k < 4; ++k) closest.offset += closest.weights[k] * corners[k];
  closest.distance = closest.offset.norm();
}

PairDistance point_triangle(const PairCorners& corners) {
  const ClosestPoint point = closest_point({corners[1], corners[2], corners[3]}, corners[0]);
  PairDistance closest;
  closest.weights << 1, -point.weights[0], -point.weights[1], -point.weights[2];
  closest.slide_count = point.corner_count - 1;
  for (int k = 0; k < closest.slide_count; ++k) {
    closest.slides(1 + point.corners[0], k) = 1;
    closest.slides(1 + point.corners[k + 1], k) = -1;
  }
  measure(corners, closest);
  return closest;
}

/// From vertex `point` to the edge from `from` to `to`; the offset is turned to point from the second edge to the
/// first.
PairDistance point_edge(const PairCorners& corners, int point, int from, int to) {
  const Eigen::Vector3d edge = corners[to] - corners[from];
  const double length = edge.squaredNorm();
  const double along = length > 0 ? std::clamp(edge.dot(corners[point] - corners[from]) / length, 0.0, 1.0) : 0;
  const double sign = point < 2 ? 1 : -1;
  PairDistance closest;
  closest.weights[point] = sign;
  closest.weights[from] = -sign * (1 - along);
  closest.weights[to] = -sign * along;
  if (along > 0 && along < 1) {
    closest.slide_count = 1;
    closest.slides(from, 0) = sign;
    closest.slides(to, 0) = -sign;
  }
  measure(corners, closest);
  return closest;
}

PairDistance edge_edge(const PairCorners& corners) {
  const Eigen::Vector3d first = corners[1] - corners[0], second = corners[3] - corners[2];
  const Eigen::Vector3d between = corners[0] - corners[2];
  const double a = first.squaredNorm(), b = first.dot(second), c = second.squaredNorm();
  const double d = first.dot(between), e = second.dot(between);
  const double determinant = a * c - b * b;
  // Below this the lines' crossing is round-off; the ends then hold a closest point as good as any.
  if (determinant > 1e-14 * a * c) {
    const double s = (b * e - c * d) / determinant, t = (a * e - b * d) / determinant;
    if (s > 0 && s < 1 && t > 0 && t < 1) {
      PairDistance closest;
      closest.weights << 1 - s, s, -(1 - t), -t;
      closest.slides << -1, 0, 1, 0, 0, 1, 0, -1;
      closest.slide_count = 2;
      measure(corners, closest);
      return closest;
    }
  }
  PairDistance best = point_edge(corners, 0, 2, 3);
  for (const auto& [point, from, to] : {std::array{1, 2, 3}, std::array{2, 0, 1}, std::array{3, 0, 1}}) {
    const PairDistance candidate = point_edge(corners, point, from, to);
    if (candidate.distance < best.distance) best = candidate;
  }
  return best;
}

}  // namespace

PairDistance pair_distance(PairKind kind, const PairCorners& corners) {
  return kind == PairKind::kPointTriangle ? point_triangle(corners) : edge_edge(corners);
}

double least_distance(PairKind kind, const PairCorners& corners) {
  if (kind == PairKind::kEdgeEdge) {
    const Eigen::Vector3d axis = corners[0] + corners[1] - corners[2] - corners[3];
    const double low = std::min(axis.dot(corners[0] - corners[2]), axis.dot(corners[0] - corners[3]));
    return std::min(low, low + axis.dot(corners[1] - corners[0])) / std::max(axis.norm(), kSmallestLength);
  }
  const Eigen::Vector3d axis = 3 * corners[0] - corners[1] - corners[2] - corners[3];
  const double low = std::min(
      {axis.dot(corners[0] - corners[1]), axis.dot(corners[0] - corners[2]), axis.dot(corners[0] - corners[3])});
  return low / std::max(axis.norm(), kSmallestLength);
}

Eigen::Matrix<double, 12, 1> distance_gradient(const PairDistance& closest) {
  Eigen::Matrix<double, 12, 1> gradient;
  for (int k = 0; k < 4; ++k) gradient.segment<3>(3 * k) = closest.weights[k] / closest.distance * closest.offset;
  return gradient;
}

Eigen::Matrix<double, 12, 12> distance_hessian(const PairDistance& closest, const PairCorners& corners) {
  Eigen::Matrix<double, 12, 12> hessian;
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) {
      hessian.block<3, 3>(3 * a, 3 * b) = closest.weights[a] * closest.weights[b] * Eigen::Matrix3d::Identity();
    }
  }
  const int slides = closest.slide_count;
  if (slides > 0) {
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 2> images(3, slides);
    images.setZero();
    for (int k = 0; k < slides; ++k) {
      for (int a = 0; a < 4; ++a) images.col(k) += closest.slides(a, k) * corners[a];
    }
    Eigen::Matrix<double, Eigen::Dynamic, 12, 0, 2, 12> coupling(slides, 12);
    for (int a = 0; a < 4; ++a) {
      for (int k = 0; k < slides; ++k) {
        coupling.block<1, 3>(k, 3 * a) =
            closest.weights[a] * images.col(k).transpose() + closest.slides(a, k) * closest.offset.transpose();
      }
    }
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2> metric = images.transpose() * images;
    hessian -= coupling.transpose() * metric.inverse() * coupling;
  }
  const Eigen::Matrix<double, 12, 1> gradient = distance_gradient(closest);
  return (hessian - gradient * gradient.transpose()) / closest.distance;
}

}  // namespace thinwall
