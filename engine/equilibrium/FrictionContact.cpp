#include "engine/equilibrium/FrictionContact.hpp"

#include <algorithm>

#include "engine/equilibrium/Equilibrium.hpp"

namespace thinwall {

Eigen::Vector3d place_on(const BodyModel& model, int triangle, const Eigen::Vector3d& weights,
                         const Eigen::VectorXd& position) {
  const auto corners = corners_of(model.surface[triangle], position);
  return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
}

Eigen::Vector3d FrictionContact::slip(const BodyModel& model, const Eigen::VectorXd& position) const {
  const Eigen::Vector3d way = place_on(model, triangle, weights, position) - origin;
  return way - normal * normal.dot(way);
}

Eigen::Vector3d FrictionContact::force(const BodyModel& model, const Eigen::VectorXd& position) const {
  return potential.stiffness() * potential.elastic_part(slip(model, position));
}

void advance_estimates(const BodyModel& model, const Eigen::VectorXd& position, const Eigen::VectorXd& motion,
                       double fraction, std::vector<FrictionContact>& contacts) {
  for (FrictionContact& contact : contacts) {
    const Eigen::Vector3d way = place_on(model, contact.triangle, contact.weights, motion);
    const Eigen::Vector3d change = way - contact.normal * contact.normal.dot(way);
    const Eigen::Vector3d next =
        contact.potential.next_estimate(contact.slip(model, position), change, contact.estimate);
    contact.estimate += fraction * (next - contact.estimate);
  }
}

void add_friction(const BodyModel& model, const std::vector<FrictionContact>& contacts, const Eigen::VectorXd& position,
                  EquilibriumTerms& terms) {
  for (const FrictionContact& contact : contacts) {
    const FrictionTerms own = contact.potential.at(contact.slip(model, position), contact.normal, contact.estimate);
    Eigen::Matrix<double, 9, 9> hessian;
    for (int a = 0; a < 3; ++a) {
      terms.gradient.segment<3>(3 * model.surface[contact.triangle][a]) += contact.weights[a] * own.gradient;
      for (int b = 0; b < 3; ++b) {
        hessian.block<3, 3>(3 * a, 3 * b) = contact.weights[a] * contact.weights[b] * own.hessian;
      }
    }
    terms.friction += own.energy;
    if (terms.has_hessian()) add_triangle(model.addresses[contact.triangle], hessian, terms.values);
    terms.largest_force = std::max(terms.largest_force, contact.potential.limit);
  }
}

}  // namespace thinwall
