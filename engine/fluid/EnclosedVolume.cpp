#include "engine/fluid/EnclosedVolume.hpp"

#include <Eigen/Geometry>

#include "engine/mesh/CrossProductMatrix.hpp"

namespace thinwall {

double volume_of(const std::array<Eigen::Vector3d, 3>& corners) {
  return corners[0].dot(corners[1].cross(corners[2])) / 6;
}

Eigen::Matrix<double, 9, 1> volume_gradient_of(const std::array<Eigen::Vector3d, 3>& corners) {
  Eigen::Matrix<double, 9, 1> gradient;
  gradient << corners[1].cross(corners[2]) / 6, corners[2].cross(corners[0]) / 6, corners[0].cross(corners[1]) / 6;
  return gradient;
}

Eigen::Matrix<double, 9, 9> volume_hessian_of(const std::array<Eigen::Vector3d, 3>& corners) {
  Eigen::Matrix<double, 9, 9> hessian = Eigen::Matrix<double, 9, 9>::Zero();
  const auto set = [&](int row, int column, const Eigen::Matrix3d& block) {
    hessian.block<3, 3>(3 * row, 3 * column) = block;
    hessian.block<3, 3>(3 * column, 3 * row) = block.transpose();
  };
  set(0, 1, -cross_product_matrix(corners[2]) / 6);
  set(1, 2, -cross_product_matrix(corners[0]) / 6);
  set(0, 2, cross_product_matrix(corners[1]) / 6);
  return hessian;
}

}  // namespace thinwall
