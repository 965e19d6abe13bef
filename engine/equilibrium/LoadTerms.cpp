#include "engine/equilibrium/LoadTerms.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/fluid/EnclosedVolume.hpp"
#include "engine/fluid/FluidWeight.hpp"

namespace thinwall {
namespace {

void add_corners(const Eigen::Vector3i& triangle, const Eigen::Matrix<double, 9, 1>& part, Eigen::VectorXd& whole) {
  for (int k = 0; k < 3; ++k) whole.segment<3>(3 * triangle[k]) += part.segment<3>(3 * k);
}

void add_follower_pressure(const BodyModel& model, const LoadModel& load, double factor,
                           const Eigen::VectorXd& position, EquilibriumTerms& terms) {
  const double pressure = factor * load.pressure;
  for (const int t : load.triangles) {
    const auto corners = corners_of(model.surface[t], position);
    const Eigen::Vector3d force = pressure / 6 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    for (const int vertex : model.surface[t]) terms.load_force.segment<3>(3 * vertex) += force;
    terms.load_work += pressure * volume_of(corners);
    if (terms.has_hessian()) {
      add_triangle(model.addresses[t], -pressure * volume_hessian_of(corners), terms.values);
    }
  }
}

/// Angle by which a lever has turned about an axis, and its derivatives by the lever.
struct Rotation {
  double angle;              // radian
  Eigen::Vector3d gradient;  // 1 / metre
  Eigen::Matrix3d hessian;   // 1 / metre^2
};
Rotation rotation_of(const Eigen::Vector3d& lever, const Eigen::Vector3d& start, const Eigen::Vector3d& axis) {
  const Eigen::Vector3d from = start - axis * axis.dot(start);
  const Eigen::Vector3d first = from.normalized(), second = axis.cross(first);
  const double p = lever.dot(first), q = lever.dot(second), square = p * p + q * q;
  Rotation rotation{.angle = std::atan2(q, p), .gradient = (p * second - q * first) / square, .hessian = {}};
  const double skew = 2 * p * q / (square * square), mixed = (q * q - p * p) / (square * square);
  rotation.hessian = skew * (first * first.transpose() - second * second.transpose()) +
                     mixed * (first * second.transpose() + second * first.transpose());
  return rotation;
}

Eigen::Vector3d lever_of(const MomentLever& lever, const std::array<Eigen::Vector3d, 3>& corners) {
  return lever.weights[0] * corners[0] + lever.weights[1] * corners[1] + lever.weights[2] * corners[2];
}

void add_moment(const BodyModel& model, const EquilibriumProblem& problem, const LoadModel& load, double factor,
                const Eigen::VectorXd& position, EquilibriumTerms& terms) {
  for (const MomentLever& lever : load.levers) {
    const Eigen::Vector3i& triangle = model.surface[lever.triangle];
    const Rotation rotation = rotation_of(lever_of(lever, corners_of(triangle, position)),
                                          lever_of(lever, corners_of(triangle, problem.start)), load.axis);
    const double moment = factor * lever.moment;
    Eigen::Matrix<double, 9, 9> hessian;
    for (int a = 0; a < 3; ++a) {
      terms.load_force.segment<3>(3 * triangle[a]) += moment * lever.weights[a] * rotation.gradient;
      for (int b = 0; b < 3; ++b) {
        hessian.block<3, 3>(3 * a, 3 * b) = -moment * lever.weights[a] * lever.weights[b] * rotation.hessian;
      }
    }
    const Eigen::Index turned = 3 * static_cast<Eigen::Index>(model.vertices()) + lever.edge;
    terms.load_work += moment * rotation.angle;
    if (lever.turn != 0) {
      terms.load_force[turned] += moment * lever.turn;
      terms.load_work += moment * lever.turn * position[turned];
    }
    if (terms.has_hessian()) add_triangle(model.addresses[lever.triangle], hessian, terms.values);
  }
}

}  // namespace

void add_weight(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                EquilibriumTerms& terms) {
  if (problem.gravity.isZero()) return;
  for (int v = 0; v < model.vertices(); ++v) {
    const Eigen::Vector3d weight = model.mass[3 * v] * problem.gravity;
    terms.gravity -= weight.dot(position.segment<3>(3 * v));
    terms.gradient.segment<3>(3 * v) -= weight;
    terms.largest_force = std::max(terms.largest_force, weight.lpNorm<Eigen::Infinity>());
  }
}

void add_fluid_weight(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                      EquilibriumTerms& terms) {
  const bool heavy = !problem.gravity.isZero(), moving = !problem.fluid_inertia.empty();
  if (problem.fluids.empty() || (!heavy && !moving)) return;
  const double density = model.definition.fluid.density;
  std::vector<Eigen::Vector3d> push(problem.fluids.size(), -density * problem.gravity);  // newton / metre^3
  for (std::size_t c = 0; c < problem.fluid_inertia.size(); ++c) {
    const FluidInertia& inertia = problem.fluid_inertia[c];
    push[c] += inertia.factor * (terms.moment.col(c) - inertia.target);
  }
  for (std::size_t t = 0; t < model.surface.size(); ++t) {
    const int chamber = model.chamber[t];
    if (chamber < 0) continue;
    const auto corners = relative_to(model.chambers[chamber].level, corners_of(model.surface[t], position));
    if (model.is_open(chamber)) {
      // Load and curvature are those of `add_open_chambers`.
      const bool whole = heavy && !problem.fluids[chamber].has_surface;
      if (whole) terms.gravity -= model.share[t] * density * fluid_moment_value(corners, problem.gravity);
      continue;
    }
    // What a triangle of a spread cap does is in proportion to what pushes it.
    const Eigen::Vector3d pushed = model.share[t] * push[chamber];
    const FluidMoment moment = fluid_moment_of(corners, pushed);
    if (heavy) terms.gravity -= model.share[t] * density * fluid_moment_value(corners, problem.gravity);
    add_corners(model.surface[t], moment.gradient, terms.gradient);
    if (terms.has_hessian()) {
      add_triangle(model.addresses[t], fluid_moment_hessian(corners, pushed), terms.values);
    }
    terms.largest_force = std::max(terms.largest_force, moment.gradient.lpNorm<Eigen::Infinity>());
  }
}

void add_loads(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
               EquilibriumTerms& terms) {
  terms.load_force.setZero(position.size());
  for (std::size_t k = 0; k < model.loads.size(); ++k) {
    const LoadModel& load = model.loads[k];
    const double factor = k < problem.load_factors.size() ? problem.load_factors[k] : 1;
    if (factor == 0) continue;
    if (load.kind == LoadKind::kFollowerPressure) {
      add_follower_pressure(model, load, factor, position, terms);
    } else if (load.kind == LoadKind::kDeadMoment) {
      add_moment(model, problem, load, factor, position, terms);
    } else {
      terms.load_force.head(load.force.size()) += factor * load.force;
      terms.load_work += factor * load.force.dot(position.head(load.force.size()));
    }
  }
  if (problem.cut_force.size() > 0) {
    terms.load_force += problem.cut_force;
    terms.load_work += problem.cut_force.dot(position);
  }
  terms.gradient -= terms.load_force;
  if (!model.loads.empty() || problem.cut_force.size() > 0) {
    terms.largest_force = std::max(terms.largest_force, terms.load_force.cwiseAbs().maxCoeff());
  }
}

}  // namespace thinwall
