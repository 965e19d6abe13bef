#include "engine/contact/FrictionPotential.hpp"

namespace thinwall {

Eigen::Vector3d FrictionPotential::elastic_part(const Eigen::Vector3d& slip) const {
  return sticks(slip) ? slip : Eigen::Vector3d(give * slip.normalized());
}

FrictionTerms FrictionPotential::at(const Eigen::Vector3d& slip, const Eigen::Vector3d& normal,
                                    const Eigen::Vector3d& estimate) const {
  const Eigen::Matrix3d tangent = Eigen::Matrix3d::Identity() - normal * normal.transpose();
  if (sticks(slip)) {
    return {.energy = 0.5 * stiffness() * slip.squaredNorm(),
            .gradient = stiffness() * slip,
            .hessian = stiffness() * tangent};
  }
  const double length = slip.norm();
  const Eigen::Vector3d along = slip / length;
  return {.energy = limit * (length - 0.5 * give),
          .gradient = limit * along,
          .hessian = (limit * tangent - 0.5 * (estimate * along.transpose() + along * estimate.transpose())) / length};
}

Eigen::Vector3d FrictionPotential::next_estimate(const Eigen::Vector3d& slip, const Eigen::Vector3d& change,
                                                 const Eigen::Vector3d& estimate) const {
  Eigen::Vector3d next = stiffness() * (slip + change);
  if (!sticks(slip)) {
    const double length = slip.norm();
    next = (limit * (slip + change) - estimate * slip.dot(change) / length) / length;
  }
  const double size = next.norm();
  return size > limit ? Eigen::Vector3d(limit / size * next) : next;
}

}  // namespace thinwall
