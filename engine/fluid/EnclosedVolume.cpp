#include "engine/fluid/EnclosedVolume.hpp"

#include <Eigen/Geometry>

#include "engine/mesh/CrossProductMatrix.hpp"

namespace thinwall {

Eigen::Matrix<double, 9, 1> volume_gradient_of(const std::array<Eigen::Vector3d, 3>& corners) {
  Eigen::Matrix<double, 9, 1> gradient;
  gradient << corners[1].cross(corners[2]) / 6, corners[2].cross(corners[0]) / 6, corners[0].cross(corners[1]) / 6;
  return gradient;
}

THINWALL_FOR_ALL_PROCESSORS void volume_gradients_of(const double (&corners)[9][kLanes],
                                                     double (&gradients)[9][kLanes]) {
  Lanes at[9];
  for (int k = 0; k < 9; ++k) load(corners[k], at[k]);
  for (int corner = 0; corner < 3; ++corner) {
    Lanes product[3];
    cross(at + 3 * ((corner + 1) % 3), at + 3 * ((corner + 2) % 3), product);
    for (int k = 0; k < 3; ++k) store(product[k] / 6, gradients[3 * corner + k]);
  }
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
