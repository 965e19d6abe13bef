#include "engine/fluid/LipCap.hpp"

#include <Eigen/Geometry>

#include "engine/fluid/EnclosedVolume.hpp"
#include "engine/fluid/FluidWeight.hpp"

namespace thinwall {
namespace {

/// Calls `visit(corners, first, second)` for each triangle of the fan: the middle, then two lips against their sense.
template <typename Visit>
void for_each_fan_triangle(const Eigen::Matrix3Xd& lips, const Visit& visit) {
  const Eigen::Vector3d middle = lips.rowwise().mean();
  for (Eigen::Index k = 0; k < lips.cols(); ++k) {
    const Eigen::Index next = (k + 1) % lips.cols();
    visit(std::array<Eigen::Vector3d, 3>{middle, lips.col(next), lips.col(k)}, next, k);
  }
}

/// Adds what belongs to the corners of a fan triangle to the lips.
void add_to_lips(const Eigen::Matrix<double, 9, 1>& part, Eigen::Index first, Eigen::Index second,
                 Eigen::Matrix3Xd& lips) {
  const Eigen::Vector3d share = part.head<3>() / static_cast<double>(lips.cols());
  lips.colwise() += share;
  lips.col(first) += part.segment<3>(3);
  lips.col(second) += part.segment<3>(6);
}

}  // namespace

LipCap lip_cap_of(const Eigen::Matrix3Xd& lips) {
  LipCap cap{.center = lips.rowwise().mean(), .volume_gradient = Eigen::Matrix3Xd::Zero(3, lips.cols())};
  for_each_fan_triangle(lips, [&](const auto& corners, Eigen::Index first, Eigen::Index second) {
    cap.area += 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    cap.volume += volume_of(corners);
    add_to_lips(volume_gradient_of(corners), first, second, cap.volume_gradient);
  });
  return cap;
}

Eigen::Matrix3Xd open_area_gradient(const Eigen::Matrix3Xd& lips, const Eigen::Vector3d& area) {
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, lips.cols());
  const double magnitude = area.norm();
  if (magnitude == 0) return gradient;
  const Eigen::Vector3d normal = area / magnitude;
  const Eigen::Index count = lips.cols();
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Vector3d across = lips.col((k + count - 1) % count) - lips.col((k + 1) % count);
    gradient.col(k) = 0.5 * across.cross(normal);
  }
  return gradient;
}

LipMoment lip_moment_of(const Eigen::Matrix3Xd& lips) {
  LipMoment moment{.value = Eigen::Vector3d::Zero(), .gradient = {}};
  for (Eigen::Matrix3Xd& gradient : moment.gradient) gradient.setZero(3, lips.cols());
  for_each_fan_triangle(lips, [&](const auto& corners, Eigen::Index first, Eigen::Index second) {
    for (int axis = 0; axis < 3; ++axis) {
      const FluidMoment part = fluid_moment_of(corners, Eigen::Vector3d::Unit(axis));
      moment.value[axis] += part.value;
      add_to_lips(part.gradient, first, second, moment.gradient[axis]);
    }
  });
  return moment;
}

Eigen::Matrix3Xd lip_sum_of(
    const Eigen::Matrix3Xd& lips,
    const std::function<Eigen::Matrix<double, 9, 1>(const std::array<Eigen::Vector3d, 3>&)>& of_triangle) {
  Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, lips.cols());
  for_each_fan_triangle(lips, [&](const auto& corners, Eigen::Index first, Eigen::Index second) {
    add_to_lips(of_triangle(corners), first, second, sum);
  });
  return sum;
}

Eigen::Matrix3Xd lip_load_of(const Eigen::Matrix3Xd& lips, const PressureField& field) {
  return lip_sum_of(lips, [&](const auto& corners) { return pressure_load_of(corners, field); });
}

}  // namespace thinwall
