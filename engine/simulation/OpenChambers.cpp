#include "engine/simulation/OpenChambers.hpp"

#include <algorithm>

#include "engine/fluid/FluidWeight.hpp"

namespace thinwall {
namespace {

/// Adds (3 x lips) to a vector of the (unknowns).
template <typename Vector>
void add_to_lips(const OpeningModel& opening, const Eigen::Matrix3Xd& part, Vector&& whole) {
  for (std::size_t k = 0; k < opening.lips.size(); ++k) {
    whole.template segment<3>(3 * opening.lips[k]) += part.col(static_cast<Eigen::Index>(k));
  }
}

void add_caps(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
              EquilibriumTerms& terms) {
  for (const OpeningModel& opening : model.openings) {
    const Eigen::Matrix3Xd lips = opening.at(position);
    terms.lips.push_back(lip_cap_of(lips));
    terms.volume[opening.chamber] += terms.lips.back().volume;
    add_to_lips(opening, terms.lips.back().volume_gradient, terms.volume_gradient.col(opening.chamber));
    const Eigen::Vector3d& level = model.chambers[opening.chamber].level;
    if (!problem.gravity.isZero()) {
      const LipMoment moment = lip_moment_of(lips.colwise() - level);
      terms.gravity -= problem.fluids[opening.chamber].density * problem.gravity.dot(moment.value);
    }
    if (problem.fluid_inertia.empty()) continue;
    const LipMoment moment = lip_moment_of(lips.colwise() - problem.fluid_inertia[opening.chamber].origin);
    terms.moment.col(opening.chamber) += moment.value;
    for (int axis = 0; axis < 3; ++axis) {
      add_to_lips(opening, moment.gradient[axis], terms.moment_gradient.col(3 * opening.chamber + axis));
    }
  }
}

/// Loads of the fields that have a unit of pressure at the origin, or a unit of slope along an axis.
void add_unit_loads(const BodyModel& model, const EquilibriumProblem& problem, int triangle,
                    const std::array<Eigen::Vector3d, 3>& corners, EquilibriumTerms& terms) {
  const int chamber = model.chamber[triangle];
  const auto add = [&](const PressureField& field, auto&& column) {
    const auto load = pressure_load_of(corners, field);
    for (int k = 0; k < 3; ++k) {
      column.template segment<3>(3 * model.surface[triangle][k]) += load.segment<3>(3 * k);
    }
  };
  add({.at_origin = 1, .slope = Eigen::Vector3d::Zero()}, terms.pressure_load.col(chamber));
  if (problem.fluid_inertia.empty()) return;
  const Eigen::Vector3d& origin = problem.fluid_inertia[chamber].origin;
  for (int axis = 0; axis < 3; ++axis) {
    add({.at_origin = -origin[axis], .slope = Eigen::Vector3d::Unit(axis)}, terms.moment_load.col(3 * chamber + axis));
  }
}

void add_loads(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
               const Eigen::VectorXd& pressure, EquilibriumTerms& terms) {
  std::vector<PressureField> whole, weight;  // with the pressure, and without it
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    whole.push_back(pressure_field(model, problem, terms, c, pressure[c]));
    weight.push_back(pressure_field(model, problem, terms, c, 0));
  }
  for (int t = 0; t < static_cast<int>(model.surface.size()); ++t) {
    const int chamber = model.chamber[t];
    if (!model.is_open(chamber)) continue;
    const auto corners = corners_of(model.surface[t], position);
    add_unit_loads(model, problem, t, corners, terms);
    const auto load = pressure_load_of(corners, weight[chamber]);
    for (int k = 0; k < 3; ++k) terms.gradient.segment<3>(3 * model.surface[t][k]) -= load.segment<3>(3 * k);
    const Eigen::Matrix<double, 9, 9> tangent = pressure_tangent_of(corners, whole[chamber]);
    add_triangle(model.addresses[t], -0.5 * (tangent + tangent.transpose()), terms.values);
    terms.largest_force = std::max(terms.largest_force, load.lpNorm<Eigen::Infinity>());
  }
  for (const OpeningModel& opening : model.openings) {
    add_to_lips(opening, lip_load_of(opening.at(position), whole[opening.chamber]), terms.lip_force);
  }
}

}  // namespace

PressureField pressure_field(const BodyModel& model, const EquilibriumProblem& problem, const EquilibriumTerms& terms,
                             int chamber, double pressure) {
  const Eigen::Vector3d weight = problem.fluids[chamber].density * problem.gravity;
  PressureField field{.at_origin = pressure - weight.dot(model.chambers[chamber].level), .slope = weight};
  if (problem.fluid_inertia.empty()) return field;
  const FluidInertia& inertia = problem.fluid_inertia[chamber];
  const Eigen::Vector3d push = inertia.factor * (terms.moment.col(chamber) - inertia.target);
  field.at_origin += push.dot(inertia.origin);
  field.slope -= push;
  return field;
}

void add_open_chambers(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                       const Eigen::VectorXd& pressure, EquilibriumTerms& terms) {
  if (!model.has_open_chambers()) return;
  add_caps(model, problem, position, terms);
  // Closed chambers share the columns: there both are the same.
  terms.pressure_load = terms.volume_gradient;
  terms.moment_load = terms.moment_gradient;
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    if (!model.is_open(c)) continue;
    terms.pressure_load.col(c).setZero();
    if (terms.moment_load.cols() > 0) terms.moment_load.middleCols<3>(3 * c).setZero();
  }
  terms.lip_force.setZero(position.size());
  add_loads(model, problem, position, pressure, terms);
  for (Eigen::Index k = 0; k < position.size(); ++k) {
    if (!model.fixed[k]) continue;
    for (Eigen::MatrixXd* columns :
         {&terms.volume_gradient, &terms.moment_gradient, &terms.pressure_load, &terms.moment_load}) {
      if (columns->cols() > 0) columns->row(k).setZero();
    }
  }
}

Eigen::VectorXd rim_forces(const BodyModel& model, const EquilibriumProblem& problem, const EquilibriumTerms& terms,
                           const Eigen::VectorXd& position, const Eigen::VectorXd& pressure,
                           const Eigen::VectorXd& motion) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(position.size());
  for (const OpeningModel& opening : model.openings) {
    const PressureField field = pressure_field(model, problem, terms, opening.chamber, pressure[opening.chamber]);
    for (std::size_t k = 0; k < opening.lips.size(); ++k) {
      const int first = opening.lips[k], second = opening.lips[(k + 1) % opening.lips.size()];
      const auto change = rim_load_change({position.segment<3>(3 * first), position.segment<3>(3 * second)},
                                          {motion.segment<3>(3 * first), motion.segment<3>(3 * second)}, field);
      forces.segment<3>(3 * first) += change[0];
      forces.segment<3>(3 * second) += change[1];
    }
  }
  return forces;
}

double lip_pressure(const BodyModel& model, const EquilibriumProblem& problem, const EquilibriumTerms& terms,
                    int opening, const Eigen::VectorXd& pressure) {
  const int chamber = model.openings[opening].chamber;
  const Eigen::Vector3d height = terms.lips[opening].center - model.chambers[chamber].level;
  return pressure[chamber] + problem.fluids[chamber].density * problem.gravity.dot(height);
}

Flow outflow(const BodyModel& model, double area, double lip_pressure) {
  return orifice_flow(model.definition.fluid.discharge, area, model.definition.fluid.density, lip_pressure);
}

OpeningEquation opening_equation(const BodyModel& model, const EquilibriumProblem& problem,
                                 const EquilibriumTerms& terms, int chamber, const Eigen::VectorXd& position,
                                 const Eigen::VectorXd& pressure, bool with_derivatives) {
  const FluidProblem& fluid = problem.fluids[chamber];
  OpeningEquation equation;
  // The fluid that leaves would have filled less space than at the pressure at which it is counted.
  const double yielding = fluid.mode == FluidMode::kCompressible ? 1 / fluid.bulk_modulus : 0;  // 1 / pascal
  const double held = fluid.held(pressure[chamber]);
  if (with_derivatives) equation.by_position.setZero(position.size());
  for (int k = 0; k < static_cast<int>(model.openings.size()); ++k) {
    const OpeningModel& opening = model.openings[k];
    if (opening.chamber != chamber || (fluid.vent >= 0 && fluid.vent != k)) continue;
    const double at_lips = lip_pressure(model, problem, terms, k, pressure);
    const Eigen::Vector3d slope = fluid.density * problem.gravity / static_cast<double>(opening.lips.size());
    Eigen::Matrix3Xd by_lips;
    if (fluid.vent >= 0) {
      equation.value += fluid.vent_compliance * at_lips;
      equation.by_pressure += fluid.vent_compliance;
      if (with_derivatives) by_lips = (fluid.vent_compliance * slope).replicate(1, opening.lips.size());
    } else {
      const Eigen::Vector3d& area = terms.lips[k].area;
      const Flow flow = outflow(model, area.norm(), at_lips);
      equation.value += fluid.outflow_time * flow.rate * held;
      equation.by_pressure += fluid.outflow_time * (flow.slope * held - flow.rate * yielding);
      if (with_derivatives) {
        const double by_area = fluid.outflow_time * outflow(model, 1, at_lips).rate * held;
        by_lips = by_area * open_area_gradient(opening.at(position), area);
        by_lips.colwise() += fluid.outflow_time * flow.slope * held * slope;
      }
    }
    if (with_derivatives) add_to_lips(opening, by_lips, equation.by_position);
  }
  for (Eigen::Index k = 0; k < equation.by_position.size(); ++k) {
    if (model.fixed[k]) equation.by_position[k] = 0;
  }
  return equation;
}

}  // namespace thinwall
