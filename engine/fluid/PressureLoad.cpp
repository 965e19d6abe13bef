#include "engine/fluid/PressureLoad.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

namespace thinwall {
namespace {

Eigen::Vector3d doubled_area_of(const std::array<Eigen::Vector3d, 3>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

Eigen::Vector3d pressures_at(const std::array<Eigen::Vector3d, 3>& corners, const PressureField& field) {
  PressureField even = field;
  even.suction = true;
  return {even.at(corners[0]), even.at(corners[1]), even.at(corners[2])};
}

Eigen::Matrix3d moments_of_whole() {
  return (Eigen::Matrix3d::Ones() + Eigen::Matrix3d::Identity()) / 24;
}

/// Integrals of the products of two shape functions over the part of a triangle where the pressure counts, over twice
/// its area: the part is cut off in barycentric coordinates and taken as a fan of triangles.
Eigen::Matrix3d moments_of(const Eigen::Vector3d& pressures, bool suction) {
  if (suction || pressures.minCoeff() >= 0) return moments_of_whole();
  if (pressures.maxCoeff() <= 0) return Eigen::Matrix3d::Zero();
  std::array<Eigen::Vector3d, 4> part;
  int count = 0;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    if (pressures[k] > 0) part[count++] = Eigen::Vector3d::Unit(k);
    if ((pressures[k] > 0) == (pressures[next] > 0)) continue;
    const double along = pressures[k] / (pressures[k] - pressures[next]);
    part[count++] = (1 - along) * Eigen::Vector3d::Unit(k) + along * Eigen::Vector3d::Unit(next);
  }
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (int k = 1; k + 1 < count; ++k) {
    Eigen::Matrix3d corners;  // (corners of the part x shape functions)
    corners << part[0].transpose(), part[k].transpose(), part[k + 1].transpose();
    moments += corners.determinant() * corners.transpose() * moments_of_whole() * corners;
  }
  return moments;
}

Eigen::Matrix3d cross_product_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

}  // namespace

Eigen::Matrix<double, 9, 1> pressure_load_of(const std::array<Eigen::Vector3d, 3>& corners,
                                             const PressureField& field) {
  const Eigen::Vector3d normal = doubled_area_of(corners), pressures = pressures_at(corners, field);
  const Eigen::Vector3d shares = moments_of(pressures, field.suction) * pressures;
  Eigen::Matrix<double, 9, 1> load;
  for (int a = 0; a < 3; ++a) load.segment<3>(3 * a) = shares[a] * normal;
  return load;
}

Eigen::Matrix<double, 9, 1> unit_load_of(const std::array<Eigen::Vector3d, 3>& corners, const PressureField& field) {
  const Eigen::Vector3d normal = doubled_area_of(corners);
  const Eigen::Vector3d shares = moments_of(pressures_at(corners, field), field.suction).rowwise().sum();
  Eigen::Matrix<double, 9, 1> load;
  for (int a = 0; a < 3; ++a) load.segment<3>(3 * a) = shares[a] * normal;
  return load;
}

Eigen::Vector3d squared_load_of(const std::array<Eigen::Vector3d, 3>& corners, const PressureField& field) {
  const Eigen::Vector3d pressures = pressures_at(corners, field);
  return 0.5 * pressures.dot(moments_of(pressures, field.suction) * pressures) * doubled_area_of(corners);
}

Eigen::Matrix<double, 9, 9> pressure_tangent_of(const std::array<Eigen::Vector3d, 3>& corners,
                                                const PressureField& field) {
  const Eigen::Vector3d normal = doubled_area_of(corners), pressures = pressures_at(corners, field);
  // Where the part ends within the triangle the pressure is zero, so that its change adds nothing.
  const Eigen::Matrix3d moments = moments_of(pressures, field.suction);
  const Eigen::Vector3d shares = moments * pressures;
  Eigen::Matrix<double, 9, 9> tangent;
  for (int b = 0; b < 3; ++b) {
    const Eigen::Matrix3d normal_change = cross_product_matrix(corners[(b + 2) % 3] - corners[(b + 1) % 3]);
    for (int a = 0; a < 3; ++a) {
      tangent.block<3, 3>(3 * a, 3 * b) = shares[a] * normal_change + moments(a, b) * normal * field.slope.transpose();
    }
  }
  return tangent;
}

std::array<Eigen::Vector3d, 2> rim_load_change(const std::array<Eigen::Vector3d, 2>& ends,
                                               const std::array<Eigen::Vector3d, 2>& motion,
                                               const PressureField& field) {
  double begin = 0, end = 1;  // of the part of the edge where the pressure counts
  const double first = field.at(ends[0]), second = field.at(ends[1]);
  if (first == 0 && second == 0) return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  if (first == 0 || second == 0) {
    const double slope = field.slope.dot(ends[1] - ends[0]);
    const double surface = -(field.at_origin + field.slope.dot(ends[0])) / slope;
    (first == 0 ? begin : end) = std::clamp(surface, 0.0, 1.0);
  }
  // Simpson's rule is exact for the product of three linear functions.
  const Eigen::Vector3d edge = ends[1] - ends[0];
  std::array<Eigen::Vector3d, 2> change = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (int k = 0; k < 3; ++k) {
    const double along = begin + 0.5 * k * (end - begin), weight = (k == 1 ? 4 : 1) * (end - begin) / 6;
    const Eigen::Vector3d moved = (1 - along) * motion[0] + along * motion[1];
    const Eigen::Vector3d part = -0.5 * weight * field.at(ends[0] + along * edge) * edge.cross(moved);
    change[0] += (1 - along) * part;
    change[1] += along * part;
  }
  return change;
}

}  // namespace thinwall
