#include "engine/fluid/FluidWeight.hpp"

#include "engine/fluid/EnclosedVolume.hpp"

namespace thinwall {

FluidMoment fluid_moment_of(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& gravity) {
  // The mean of g . x over the tetrahedron is its value at the centroid, a quarter of the sum of the corners.
  const double volume = volume_of(corners);
  const double mean = 0.25 * gravity.dot(corners[0] + corners[1] + corners[2]);
  const Eigen::Matrix<double, 9, 1> volume_gradient = volume_gradient_of(corners);
  Eigen::Matrix<double, 9, 1> mean_gradient;
  mean_gradient << 0.25 * gravity, 0.25 * gravity, 0.25 * gravity;
  return {.value = mean * volume,
          .gradient = mean * volume_gradient + volume * mean_gradient,
          .hessian = mean * volume_hessian_of(corners) + volume_gradient * mean_gradient.transpose() +
                     mean_gradient * volume_gradient.transpose()};
}

FirstMoment first_moment_of(const std::array<Eigen::Vector3d, 3>& corners) {
  const double volume = volume_of(corners);
  const Eigen::Vector3d mean = 0.25 * (corners[0] + corners[1] + corners[2]);
  FirstMoment moment{.value = volume * mean, .gradient = volume_gradient_of(corners) * mean.transpose()};
  for (int k = 0; k < 3; ++k) moment.gradient.block<3, 3>(3 * k, 0).diagonal().array() += 0.25 * volume;
  return moment;
}

}  // namespace thinwall
