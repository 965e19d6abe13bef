#include "engine/equilibrium/LeastMotion.hpp"

namespace thinwall {

LeastMotionTerms least_motion_terms(const BodyModel& model, const LeastMotion& motion, const Eigen::VectorXd& position,
                                    int triangle) {
  const MembraneRest& rest = model.rest[triangle];
  const double stiffness = motion.part * model.wall_stiffness;  // newton / metre
  const double tension = stiffness / rest.thickness;            // pascal
  LeastMotionTerms terms{.energy = 0, .gradient = {}, .hessian = geometric_stiffness(rest, {tension, tension, 0})};
  terms.hessian.diagonal().array() += stiffness * rest.area / (3 * model.rest_area);
  Eigen::Matrix<double, 9, 1> moved;
  for (int k = 0; k < 3; ++k) {
    const int first = 3 * model.surface[triangle][k];
    moved.segment<3>(3 * k) = position.segment<3>(first) - motion.from.segment<3>(first);
  }
  terms.gradient = terms.hessian * moved;
  terms.energy = 0.5 * moved.dot(terms.gradient);
  return terms;
}

void add_least_motion(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                      EquilibriumTerms& terms) {
  if (!problem.seeks_least_motion()) return;
  for (int t = 0; t < model.triangles(); ++t) {
    const LeastMotionTerms part = least_motion_terms(model, problem.least_motion, position, t);
    terms.elastic += part.energy;
    for (int k = 0; k < 3; ++k) {
      terms.gradient.segment<3>(3 * model.surface[t][k]) += part.gradient.segment<3>(3 * k);
    }
    if (terms.has_hessian()) add_triangle(model.addresses[t], part.hessian, terms.values);
  }
}

}  // namespace thinwall
