#include "engine/fluid/PressureLoad.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

namespace thinwall {
namespace {

Eigen::Vector3d doubled_area_of(const std::array<Eigen::Vector3d, 3>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

Eigen::Matrix3d moments_of_whole() {
  return (Eigen::Matrix3d::Ones() + Eigen::Matrix3d::Identity()) / 24;
}

Eigen::Matrix<double, 9, 1> along(const Eigen::Vector3d& normal, const Eigen::Vector3d& shares) {
  Eigen::Matrix<double, 9, 1> load;
  for (int a = 0; a < 3; ++a) load.segment<3>(3 * a) = shares[a] * normal;
  return load;
}

/// Adds v x to a block.
void add_cross_product(const Eigen::Vector3d& v, auto&& block) {
  block(0, 1) -= v.z();
  block(0, 2) += v.y();
  block(1, 0) += v.z();
  block(1, 2) -= v.x();
  block(2, 0) -= v.y();
  block(2, 1) += v.x();
}

}  // namespace

Eigen::Matrix3d pressed_moments(const Eigen::Vector3d& pressures, bool suction) {
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

PressedTriangle::PressedTriangle(const std::array<Eigen::Vector3d, 3>& corners, const PressureField& field)
    : normal_(doubled_area_of(corners)),
      edges_{corners[2] - corners[1], corners[0] - corners[2], corners[1] - corners[0]},
      slope_(field.slope) {
  for (int k = 0; k < 3; ++k) pressures_[k] = field.at_origin + field.slope.dot(corners[k]);
  // Where the part ends within the triangle the pressure is zero, so that its change adds nothing.
  moments_ = pressed_moments(pressures_, field.suction);
  shares_ = moments_ * pressures_;
}

Eigen::Matrix<double, 9, 1> PressedTriangle::load() const {
  return along(normal_, shares_);
}

Eigen::Matrix<double, 9, 1> PressedTriangle::unit_load() const {
  return along(normal_, moments_.rowwise().sum());
}

Eigen::Vector3d PressedTriangle::squared_load() const {
  return 0.5 * pressures_.dot(shares_) * normal_;
}

Eigen::Matrix<double, 9, 9> PressedTriangle::symmetric_tangent() const {
  // The derivative of f_a by corner b is shares_a (edge_b x) + J_ab n slope^T.
  Eigen::Matrix3d tilt;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      tilt(row, column) = 0.5 * (normal_[row] * slope_[column] + slope_[row] * normal_[column]);
    }
  }
  Eigen::Matrix<double, 9, 9> tangent;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      auto block = tangent.block<3, 3>(3 * a, 3 * b);
      block = moments_(a, b) * tilt;
      if (a != b) add_cross_product(0.5 * (shares_[a] * edges_[b] - shares_[b] * edges_[a]), block);
    }
  }
  return tangent;
}

Eigen::Matrix<double, 9, 3> moment_loads_of(const std::array<Eigen::Vector3d, 3>& corners) {
  const Eigen::Vector3d normal = doubled_area_of(corners), sum = corners[0] + corners[1] + corners[2];
  Eigen::Matrix<double, 9, 3> loads;
  for (int a = 0; a < 3; ++a) {
    const Eigen::Vector3d shares = (corners[a] + sum) / 24;
    for (int axis = 0; axis < 3; ++axis) loads.block<3, 1>(3 * a, axis) = shares[axis] * normal;
  }
  return loads;
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
