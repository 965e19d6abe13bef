#include "engine/fluid/PressureLoad.hpp"

#include <Eigen/Geometry>

namespace thinwall {
namespace {

Eigen::Vector3d doubled_area_of(const std::array<Eigen::Vector3d, 3>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

/// Integral over the triangle of the shape functions times the pressure, over twice its area, pascal.
Eigen::Vector3d shares_of(const std::array<Eigen::Vector3d, 3>& corners, const PressureField& field) {
  const Eigen::Vector3d pressure(field.at(corners[0]), field.at(corners[1]), field.at(corners[2]));
  return (Eigen::Vector3d::Constant(pressure.sum()) + pressure) / 24;
}

Eigen::Matrix3d cross_product_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

}  // namespace

Eigen::Matrix<double, 9, 1> pressure_load_of(const std::array<Eigen::Vector3d, 3>& corners,
                                             const PressureField& field) {
  const Eigen::Vector3d normal = doubled_area_of(corners), shares = shares_of(corners, field);
  Eigen::Matrix<double, 9, 1> load;
  for (int a = 0; a < 3; ++a) load.segment<3>(3 * a) = shares[a] * normal;
  return load;
}

Eigen::Matrix<double, 9, 9> pressure_tangent_of(const std::array<Eigen::Vector3d, 3>& corners,
                                                const PressureField& field) {
  const Eigen::Vector3d normal = doubled_area_of(corners), shares = shares_of(corners, field);
  Eigen::Matrix<double, 9, 9> tangent;
  for (int b = 0; b < 3; ++b) {
    const Eigen::Matrix3d normal_change = cross_product_matrix(corners[(b + 2) % 3] - corners[(b + 1) % 3]);
    for (int a = 0; a < 3; ++a) {
      tangent.block<3, 3>(3 * a, 3 * b) =
          shares[a] * normal_change + (a == b ? 2.0 : 1.0) / 24 * normal * field.slope.transpose();
    }
  }
  return tangent;
}

std::array<Eigen::Vector3d, 2> rim_load_change(const std::array<Eigen::Vector3d, 2>& ends,
                                               const std::array<Eigen::Vector3d, 2>& motion,
                                               const PressureField& field) {
  const double first = field.at(ends[0]), second = field.at(ends[1]);
  const double mixed = (first + second) / 12;
  const Eigen::Vector3d edge = ends[1] - ends[0];
  return {-0.5 * edge.cross((3 * first + second) / 12 * motion[0] + mixed * motion[1]),
          -0.5 * edge.cross(mixed * motion[0] + (first + 3 * second) / 12 * motion[1])};
}

}  // namespace thinwall
