#include "engine/fluid/FluidWeight.hpp"

#include "engine/fluid/EnclosedVolume.hpp"
#include "engine/mesh/CrossProductMatrix.hpp"

namespace thinwall {

namespace {

/// The mean of g . x over the tetrahedron is its value at the centroid, a quarter of the sum of the corners.
double mean_of(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& gravity) {
  return 0.25 * gravity.dot(corners[0] + corners[1] + corners[2]);
}

}  // namespace

double fluid_moment_value(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& gravity) {
  return mean_of(corners, gravity) * volume_of(corners);
}

FluidMoment fluid_moment_of(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& gravity) {
  const double volume = volume_of(corners), mean = mean_of(corners, gravity);
  const Eigen::Matrix<double, 9, 1> by_volume = volume_gradient_of(corners);
  FluidMoment moment{.value = mean * volume, .gradient = mean * by_volume};
  for (int a = 0; a < 3; ++a) moment.gradient.segment<3>(3 * a) += volume * (0.25 * gravity);
  return moment;
}

Eigen::Matrix<double, 9, 9> fluid_moment_hessian(const std::array<Eigen::Vector3d, 3>& corners,
                                                 const Eigen::Vector3d& gravity) {
  const double mean = mean_of(corners, gravity);
  const Eigen::Matrix<double, 9, 1> by_volume = volume_gradient_of(corners);
  const Eigen::Vector3d quarter = 0.25 * gravity;  // of the mean by each corner
  Eigen::Matrix<double, 9, 9> hessian;
  // Of the volume's Hessian, below the diagonal.
  const std::array<Eigen::Matrix3d, 3> turning = {cross_product_matrix(corners[2]) / 6,
                                                  -cross_product_matrix(corners[1]) / 6,
                                                  cross_product_matrix(corners[0]) / 6};
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b <= a; ++b) {
      Eigen::Matrix3d block = by_volume.segment<3>(3 * a).lazyProduct(quarter.transpose());
      block += quarter.lazyProduct(by_volume.segment<3>(3 * b).transpose());
      if (a != b) block += mean * turning[a + b - 1];
      hessian.block<3, 3>(3 * a, 3 * b) = block;
      if (a != b) hessian.block<3, 3>(3 * b, 3 * a) = block.transpose();
    }
  }
  return hessian;
}

FirstMoment first_moment_of(const std::array<Eigen::Vector3d, 3>& corners) {
  const double volume = volume_of(corners);
  const Eigen::Vector3d mean = 0.25 * (corners[0] + corners[1] + corners[2]);
  FirstMoment moment{.value = volume * mean, .gradient = volume_gradient_of(corners) * mean.transpose()};
  for (int k = 0; k < 3; ++k) moment.gradient.block<3, 3>(3 * k, 0).diagonal().array() += 0.25 * volume;
  return moment;
}

THINWALL_FOR_ALL_PROCESSORS void first_moments_of(const double (&corners)[9][kLanes], FirstMoments& moments) {
  Lanes at[9], by_volume[9];
  for (int k = 0; k < 9; ++k) load(corners[k], at[k]);
  Lanes products[3];
  for (int corner = 0; corner < 3; ++corner) {
    Lanes product[3];
    cross(at + 3 * ((corner + 1) % 3), at + 3 * ((corner + 2) % 3), product);
    for (int k = 0; k < 3; ++k) {
      by_volume[3 * corner + k] = product[k] / 6;
      if (corner == 0) products[k] = at[k] * product[k];
    }
  }
  const Lanes volume = (products[0] + products[1] + products[2]) / 6, quarter = 0.25 * volume;
  for (int axis = 0; axis < 3; ++axis) {
    const Lanes mean = 0.25 * (at[axis] + at[3 + axis] + at[6 + axis]);
    store(volume * mean, moments.value[axis]);
    for (int k = 0; k < 9; ++k) {
      Lanes slope = by_volume[k] * mean;
      if (k % 3 == axis) slope += quarter;
      store(slope, moments.gradient[axis][k]);
    }
  }
}

}  // namespace thinwall
