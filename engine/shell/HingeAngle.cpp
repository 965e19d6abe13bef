#include "engine/shell/HingeAngle.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "engine/mesh/CrossProductMatrix.hpp"

namespace thinwall {
namespace {

/// What one of the triangles, (p, q, a), adds to the gradient, and its derivative. Not symmetric by itself: only the
/// angle between both triangles is a function of positions.
struct Half {
  Eigen::Matrix<double, 9, 1> gradient;    // 1 / metre
  Eigen::Matrix<double, 9, 9> derivative;  // 1 / metre^2, row of the gradient, column of the position
};

Half half_of(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& a) {
  const Eigen::Vector3d edge = q - p, arm = a - p, normal = edge.cross(arm);
  const double square = normal.squaredNorm(), length = edge.norm();
  const double foot = arm.dot(edge) / (length * length);
  const Eigen::Vector3d lift = length / square * normal;

  // By the edge and the arm first.
  const Eigen::Matrix3d along_normal =
      length / square * (Eigen::Matrix3d::Identity() - 2 / square * normal * normal.transpose());
  const Eigen::Matrix3d lift_by_edge =
      along_normal * -cross_product_matrix(arm) + normal * edge.transpose() / (length * square);
  const Eigen::Matrix3d lift_by_arm = along_normal * cross_product_matrix(edge);
  const Eigen::Vector3d foot_by_edge = (arm - 2 * foot * edge) / (length * length);
  const Eigen::Vector3d foot_by_arm = edge / (length * length);

  Half half;
  half.gradient << (foot - 1) * lift, -foot * lift, lift;
  Eigen::Matrix<double, 9, 3> by_edge, by_arm;
  by_edge << (foot - 1) * lift_by_edge + lift * foot_by_edge.transpose(),
      -foot * lift_by_edge - lift * foot_by_edge.transpose(), lift_by_edge;
  by_arm << (foot - 1) * lift_by_arm + lift * foot_by_arm.transpose(),
      -foot * lift_by_arm - lift * foot_by_arm.transpose(), lift_by_arm;
  half.derivative << -by_edge - by_arm, by_edge, by_arm;
  return half;
}

/// Normals of both triangles, as long as twice their areas.
struct Normals {
  Eigen::Vector3d one, other;  // metres^2
};

Normals normals_of(const Hinge& hinge) {
  const auto& [p, q, a, b] = hinge;
  const Eigen::Vector3d edge = q - p;
  return {.one = edge.cross(a - p), .other = (b - p).cross(edge)};
}

/// Of the angle, times the lengths of both normals.
double sine_of(const Hinge& hinge, const Normals& normals) {
  const Eigen::Vector3d edge = hinge[1] - hinge[0];
  return -normals.one.cross(normals.other).dot(edge) / edge.norm();
}

}  // namespace

double hinge_angle(const Hinge& hinge) {
  const Normals normals = normals_of(hinge);
  return std::atan2(sine_of(hinge, normals), normals.one.dot(normals.other));
}

bool is_folded_back(const Hinge& hinge) {
  const Normals normals = normals_of(hinge);
  return normals.one.dot(normals.other) < 0;
}

bool passes_through(const Hinge& before, const Hinge& after) {
  if (!is_folded_back(before) || !is_folded_back(after)) return false;
  return sine_of(before, normals_of(before)) * sine_of(after, normals_of(after)) < 0;
}

HingeDerivatives hinge_derivatives(const Hinge& hinge) {
  const auto& [p, q, a, b] = hinge;
  const Half one = half_of(p, q, a), other = half_of(q, p, b);
  constexpr std::array<int, 3> kOne = {0, 1, 2}, kOther = {1, 0, 3};
  HingeDerivatives result;
  result.gradient.setZero();
  result.hessian.setZero();
  for (int i = 0; i < 3; ++i) {
    result.gradient.segment<3>(3 * kOne[i]) += one.gradient.segment<3>(3 * i);
    result.gradient.segment<3>(3 * kOther[i]) += other.gradient.segment<3>(3 * i);
    for (int j = 0; j < 3; ++j) {
      result.hessian.block<3, 3>(3 * kOne[i], 3 * kOne[j]) += one.derivative.block<3, 3>(3 * i, 3 * j);
      result.hessian.block<3, 3>(3 * kOther[i], 3 * kOther[j]) += other.derivative.block<3, 3>(3 * i, 3 * j);
    }
  }
  return result;
}

}  // namespace thinwall
