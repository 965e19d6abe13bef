#include "engine/shell/BendingElement.hpp"

#include <Eigen/Geometry>

namespace thinwall {
namespace {

Eigen::Matrix3d cross_product_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// The normal N = x0 x x1 + x1 x x2 + x2 x x0, its unit vector, and derivatives by the corners.
struct Normal {
  Eigen::Vector3d unit;
  double length;                                // metres^2
  Eigen::Matrix<double, 3, 9> derivative;       // of N, metres
  Eigen::Matrix<double, 9, 1> along;            // of the length, metres
  Eigen::Matrix<double, 3, 9> unit_derivative;  // 1 / metre
};

Normal normal_of(const BendingPatch& patch) {
  Normal normal;
  const Eigen::Vector3d n = (patch[1] - patch[0]).cross(patch[2] - patch[0]);
  normal.length = n.norm();
  normal.unit = n / normal.length;
  for (int a = 0; a < 3; ++a) {
    normal.derivative.block<3, 3>(0, 3 * a) = cross_product_matrix(patch[(a + 2) % 3] - patch[(a + 1) % 3]);
  }
  normal.along = normal.derivative.transpose() * normal.unit;
  normal.unit_derivative = (normal.derivative - normal.unit * normal.along.transpose()) / normal.length;
  return normal;
}

/// Second derivative of v . N by the corners.
Eigen::Matrix<double, 9, 9> normal_hessian(const Eigen::Vector3d& v) {
  Eigen::Matrix<double, 9, 9> hessian = Eigen::Matrix<double, 9, 9>::Zero();
  const Eigen::Matrix3d cross = cross_product_matrix(v);
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3;
    hessian.block<3, 3>(3 * a, 3 * b) = -cross;
    hessian.block<3, 3>(3 * b, 3 * a) = cross;
  }
  return hessian;
}

Eigen::Matrix3d second_derivatives(const BendingRest& rest, const BendingPatch& patch) {
  Eigen::Matrix3d columns = rest.held;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 6; ++i) columns.col(k) += rest.shares(k, i) * patch[i];
  }
  return columns;
}

}  // namespace

Eigen::Vector3d bending_strain(const BendingRest& rest, const BendingPatch& patch) {
  return second_derivatives(rest, patch).transpose() * normal_of(patch).unit - rest.curvature;
}

BendingTerms bending_terms(const BendingRest& rest, const BendingPatch& patch, const BendingMemory& memory) {
  const Normal normal = normal_of(patch);
  const Eigen::Matrix3d bent = second_derivatives(rest, patch);
  const Eigen::Vector3d strain = bent.transpose() * normal.unit - rest.curvature;
  const Eigen::Vector3d elastic = rest.stiffness * strain;
  const Eigen::Vector3d moment = rest.area * (memory.scale * elastic + memory.overmoment);

  // Rows: gradients of the three curvatures, share t for each vertex and b . dt for the corners.
  Eigen::Matrix<double, 3, 18> slopes;
  for (int i = 0; i < 6; ++i) slopes.block<3, 3>(0, 3 * i) = rest.shares.col(i) * normal.unit.transpose();
  slopes.leftCols<9>() += bent.transpose() * normal.unit_derivative;

  BendingTerms terms;
  terms.bending_energy = 0.5 * rest.area * strain.dot(elastic);
  terms.energy = memory.scale * terms.bending_energy + rest.area * memory.overmoment.dot(strain);
  terms.gradient = slopes.transpose() * moment;
  const Eigen::Matrix<double, 3, 18> stiff = (rest.area * memory.scale * rest.stiffness).lazyProduct(slopes);
  terms.hessian = slopes.transpose().lazyProduct(stiff);

  // Second derivatives of the curvatures, weighted with the moments: of the product of share and normal,
  const Eigen::Matrix<double, 6, 1> shares = rest.shares.transpose() * moment;
  for (int i = 0; i < 6; ++i) {
    const Eigen::Matrix<double, 3, 9> part = shares[i] * normal.unit_derivative;
    terms.hessian.block<3, 9>(3 * i, 0) += part;
    terms.hessian.block<9, 3>(0, 3 * i) += part.transpose();
  }
  // and of b . N / |N| with b held.
  const Eigen::Vector3d b = bent * moment;
  const double value = b.dot(normal.unit), length = normal.length;
  const Eigen::Matrix<double, 9, 1> by_b = normal.derivative.transpose() * b;
  const Eigen::Matrix<double, 9, 9> length_hessian =
      (normal.derivative.transpose() * normal.derivative - normal.along * normal.along.transpose()) / length +
      normal_hessian(normal.unit);
  terms.hessian.topLeftCorner<9, 9>() +=
      normal_hessian(b) / length -
      (by_b * normal.along.transpose() + normal.along * by_b.transpose()) / (length * length) +
      value * (2 * normal.along * normal.along.transpose() / (length * length) - length_hessian / length);
  return terms;
}

}  // namespace thinwall
