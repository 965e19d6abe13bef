#include "engine/equilibrium/Equilibrium.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/equilibrium/ContactSearch.hpp"
#include "engine/equilibrium/LeastMotion.hpp"
#include "engine/equilibrium/LoadTerms.hpp"
#include "engine/equilibrium/OpenChambers.hpp"
#include "engine/equilibrium/SideBySide.hpp"
#include "engine/equilibrium/WallTriangle.hpp"
#include "engine/fluid/EnclosedVolume.hpp"
#include "engine/fluid/FluidWeight.hpp"
#include "engine/shell/BendingPatches.hpp"
#include "engine/wall/MembraneLanes.hpp"

namespace thinwall {
namespace {

/// Triangles from which on a second thread is worth its while.
constexpr int kWorthTwoThreads = 1000;

void add_lane(const BodyModel& model, int triangle, const MembraneLanes& part, int lane, EquilibriumTerms& terms) {
  terms.elastic += part.energy[lane];
  terms.strain_energy += part.strain_energy[lane];
  for (int k = 0; k < 9; ++k) terms.gradient[3 * model.surface[triangle][k / 3] + k % 3] += part.gradient[k][lane];
  if (terms.has_hessian()) add_triangle(model.addresses[triangle], &part.hessian[0][0][lane], kLanes, terms.values);
  terms.largest_force = std::max(terms.largest_force, part.largest_force[lane]);
}

void add_wall(const BodyModel& model, const WallMemory& memory, const Eigen::VectorXd& position,
              EquilibriumTerms& terms) {
  thread_local std::vector<MembraneLanes> buffer;
  const int triangles = model.triangles();
  for_each((triangles + kLanes - 1) / kLanes, kTrianglesAtOnce / kLanes, buffer,
           [&](int group, MembraneLanes& part) {
             std::array<MembraneTriangle, kLanes> members;
             const int first = kLanes * group, count = std::min(kLanes, triangles - first);
             for (int k = 0; k < count; ++k) members[k] = wall_triangle(model, memory, position, first + k);
             membrane_lanes({members.data(), static_cast<std::size_t>(count)}, terms.has_hessian(), part);
           },
           [&](int group, const MembraneLanes& part) {
             const int first = kLanes * group, end = std::min(first + kLanes, triangles);
             for (int t = first; t < end; ++t) add_lane(model, t, part, t - first, terms);
           });
}

void add_bending(const BodyModel& model, const WallMemory& memory, const Eigen::VectorXd& position,
                 EquilibriumTerms& terms) {
  thread_local std::vector<BendingTerms> buffer;
  for_each(
      static_cast<int>(model.bending.size()), kTrianglesAtOnce, buffer,
      [&](int t, BendingTerms& part) {
        part = bending_terms(model.bending[t], patch_of(model.bending[t], position, model.vertices()),
                             memory.of_bending(t));
      },
      [&](int t, const BendingTerms& part) {
        terms.bending += part.energy;
        terms.bending_energy += part.bending_energy;
        const std::array<int, 21> unknowns = unknowns_of(model.bending[t], model.vertices());
        for (int k = 0; k < 21; ++k) terms.gradient[unknowns[k]] += part.gradient[k];
        if (terms.has_hessian()) add_dense(model.bending_addresses[t], part.hessian, terms.values);
        terms.largest_force = std::max(terms.largest_force, part.gradient.cwiseAbs().maxCoeff());
      });
}

/// Volume and its gradient of a triangle, as lane `lane` of `gradients` has it.
void add_volume(const BodyModel& model, int triangle, const double (&corners)[9][kLanes],
                const double (&gradients)[9][kLanes], int lane, EquilibriumTerms& terms) {
  const int chamber = model.chamber[triangle];
  const double share = model.share[triangle];
  // Of its corners the volume is linear in each.
  terms.volume[chamber] +=
      share * Eigen::Vector3d(corners[0][lane], corners[1][lane], corners[2][lane])
                  .dot(Eigen::Vector3d(gradients[0][lane], gradients[1][lane], gradients[2][lane]));
  scatter_lane(model.surface[triangle], gradients, lane, share, terms.volume_gradient.col(chamber).data());
}

void add_first_moment(const BodyModel& model, int triangle, const FirstMoments& moments, int lane,
                      EquilibriumTerms& terms) {
  const int chamber = model.chamber[triangle];
  for (int axis = 0; axis < 3; ++axis) {
    terms.moment(axis, chamber) += model.share[triangle] * moments.value[axis][lane];
    scatter_lane(model.surface[triangle], moments.gradient[axis], lane, model.share[triangle],
                 terms.moment_gradient.col(3 * chamber + axis).data());
  }
}

/// Of the triangles from `first` on, with what they are seen from.
void find_first_moments(const BodyModel& model, const EquilibriumProblem& problem, int first, int count,
                        const double (&corners)[9][kLanes], FirstMoments& moments) {
  double relative[9][kLanes] = {};
  for (int lane = 0; lane < count; ++lane) {
    const int chamber = model.chamber[first + lane];
    if (chamber < 0) continue;
    for (int k = 0; k < 9; ++k) relative[k][lane] = corners[k][lane] - problem.fluid_inertia[chamber].origin[k % 3];
  }
  first_moments_of(relative, moments);
}

/// Volumes and first moments of the chambers with their gradients, of the surface alone.
void add_volumes(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                 EquilibriumTerms& terms) {
  const bool has_inertia = terms.moment.cols() > 0;
  double corners[9][kLanes] = {}, gradients[9][kLanes];
  FirstMoments moments;
  for (int first = 0; first < static_cast<int>(model.surface.size()); first += kLanes) {
    const int count = gather_corners(model.surface, position, first, corners);
    volume_gradients_of(corners, gradients);
    if (has_inertia) find_first_moments(model, problem, first, count, corners, moments);
    for (int lane = 0; lane < count; ++lane) {
      if (model.chamber[first + lane] < 0) continue;
      add_volume(model, first + lane, corners, gradients, lane, terms);
      if (has_inertia) add_first_moment(model, first + lane, moments, lane, terms);
    }
  }
  for (Eigen::Index k = 0; k < position.size(); ++k) {
    if (!model.fixed[k]) continue;
    terms.volume_gradient.row(k).setZero();
    if (terms.moment_gradient.cols() > 0) terms.moment_gradient.row(k).setZero();
  }
}

/// The Hessian of closed chambers' volumes, and the largest load.
void add_pressure(const BodyModel& model, const Eigen::VectorXd& position, const Eigen::VectorXd& pressure,
                  EquilibriumTerms& terms) {
  bool any = false;
  for (Eigen::Index chamber = 0; chamber < pressure.size(); ++chamber) {
    const double largest = terms.volume_gradient.col(chamber).cwiseAbs().maxCoeff();
    terms.largest_force = std::max(terms.largest_force, std::abs(pressure[chamber]) * largest);
    any = any || (pressure[chamber] != 0 && !model.is_open(static_cast<int>(chamber)));
  }
  if (!any || !terms.has_hessian()) return;
  for (int t = 0; t < static_cast<int>(model.surface.size()); ++t) {
    const int chamber = model.chamber[t];
    if (chamber < 0 || pressure[chamber] == 0 || model.is_open(chamber)) continue;
    const auto corners = corners_of(model.surface[t], position);
    const double sixth = model.share[t] * pressure[chamber] / 6;
    add_cross_products(model.addresses[t], {sixth * corners[2], sixth * corners[0], -sixth * corners[1]}, terms.values);
  }
}

double inertial_energy(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position) {
  if (problem.inertia == 0) return 0;
  return 0.5 * problem.inertia * model.mass.dot((position - problem.inertia_target).cwiseAbs2());
}

double inertial_energy(const EquilibriumProblem& problem, const EquilibriumTerms& terms) {
  double energy = 0;
  for (std::size_t c = 0; c < problem.fluid_inertia.size(); ++c) {
    const FluidInertia& inertia = problem.fluid_inertia[c];
    energy += 0.5 * inertia.factor * (terms.moment.col(c) - inertia.target).squaredNorm();
  }
  return energy;
}

}  // namespace

Eigen::Vector3d material_point(const Attachment& attachment, const Eigen::VectorXd& position) {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) point += attachment.weights[k] * position.segment<3>(3 * attachment.vertices[k]);
  return point;
}

void evaluate(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
              const Eigen::VectorXd& pressure, bool with_hessian, EquilibriumTerms& terms,
              const std::function<void()>& meanwhile) {
  terms.elastic = terms.strain_energy = terms.bending = terms.bending_energy = terms.gravity = terms.load_work =
      terms.friction = terms.largest_force = 0;
  terms.gradient.setZero(position.size());
  const auto chambers = static_cast<Eigen::Index>(problem.fluids.size());
  terms.volume.setZero(chambers);
  terms.volume_gradient.setZero(position.size(), chambers);
  const auto moving = static_cast<Eigen::Index>(problem.fluid_inertia.size());
  terms.moment.setZero(3, moving);
  terms.moment_gradient.setZero(position.size(), 3 * moving);
  terms.values.assign(with_hessian ? model.pattern.nonzeros() : 0, 0);
  terms.contacts.clear();
  terms.lips.clear();
  // Neither writes what the other reads or writes.
  side_by_side(
      model.triangles() >= kWorthTwoThreads,
      [&] {
        add_wall(model, problem.memory, position, terms);
        add_bending(model, problem.memory, position, terms);
        add_least_motion(model, problem, position, terms);
      },
      [&] {
        if (chambers > 0) add_volumes(model, problem, position, terms);
        find_contacts(model, problem, position, terms);
        if (meanwhile) meanwhile();
      });
  if (chambers > 0) {
    add_pressure(model, position, pressure, terms);
    add_open_chambers(model, problem, position, pressure, terms);
  }
  add_weight(model, problem, position, terms);
  add_fluid_weight(model, problem, position, terms);
  add_loads(model, problem, position, terms);
  add_friction(model, problem.friction, position, terms);
  add_shafts(model, problem.shafts, position, terms);
  terms.inertial = inertial_energy(model, problem, position) + inertial_energy(problem, terms);
}

namespace {

/// Area of the ellipse, across `normal`, that an even pressure would have to fill for the second moments given.
double even_area(const Eigen::Matrix3d& moments, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d one = normal.unitOrthogonal(), other = normal.cross(one);
  const double a = one.dot(moments * one), b = other.dot(moments * other), c = one.dot(moments * other);
  return 4 * std::numbers::pi * std::sqrt(std::max(0.0, a * b - c * c));
}

/// The last of the rims and corners that follow a solid.
int last_part(const EquilibriumProblem& problem, int solid) {
  int last = solid;
  while (last + 1 < static_cast<int>(problem.solids.size()) && problem.solids[last + 1].solid.is_part()) {
    ++last;
  }
  return last;
}

}  // namespace

ToolContact contact_on(const BodyModel& model, const EquilibriumProblem& problem, const EquilibriumTerms& terms,
                       const Eigen::VectorXd& position, int solid) {
  const SolidContact& contact = problem.solids[solid];
  ToolContact sum;
  const bool is_part = contact.solid.is_part();
  const int last = is_part ? solid : last_part(problem, solid);
  double pressed = 0;
  Eigen::Vector3d whole_force = Eigen::Vector3d::Zero();
  Eigen::Vector3d center = Eigen::Vector3d::Zero();   // newton metres, relative to the solid's
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();  // newton metres^2
  for (const ContactPoint& point : terms.contacts) {
    if (point.solid < solid || point.solid > last) continue;
    const double force = problem.solids[point.solid].forces[point.site];
    if (force == 0) continue;
    const auto corners = corners_of(model.surface[point.triangle], position);
    Eigen::Vector3d arm = -contact.solid.center;
    for (int k = 0; k < 3; ++k) arm += point.gap.weights[k] * corners[k];
    whole_force -= force * point.gap.normal;
    pressed += force;
    center += force * arm;
    moments += force * arm * arm.transpose();
    if (point.solid != solid) continue;
    sum.force -= force * point.gap.normal;
    sum.moment -= force * arm.cross(point.gap.normal);
    sum.touching = true;
  }
  if (pressed == 0 || is_part) return sum;
  center /= pressed;
  moments = moments / pressed - center * center.transpose();
  if (contact.solid.is_ball()) {
    // Even pressure on a cap of half angle a adds up to (1 + cos a) / 2 of the sum of its forces' magnitudes.
    const double whole = 4 * std::numbers::pi * contact.solid.radius * contact.solid.radius;
    sum.area = whole * std::max(0.0, 1 - whole_force.norm() / pressed);
  } else if (whole_force.norm() > 0) {
    const Eigen::Vector3d normal = whole_force.normalized();
    sum.area = std::min(even_area(moments, normal), silhouette(contact.solid, normal));
  }
  sum.area = std::max(sum.area, pressed / contact.hugging_pressure);
  return sum;
}

double contact_energy(const EquilibriumTerms& terms) {
  double energy = 0;
  for (const ContactPoint& contact : terms.contacts) energy += contact.potential.energy(contact.gap.gap);
  return energy;
}

Eigen::VectorXd pressures_at_origin(const BodyModel& model, const Eigen::Vector3d& gravity,
                                    const Eigen::VectorXd& pressure) {
  Eigen::VectorXd at_origin = pressure;
  for (Eigen::Index c = 0; c < pressure.size(); ++c) {
    at_origin[c] -= model.definition.fluid.density * gravity.dot(model.chambers[c].level);
  }
  return at_origin;
}

Flow flow_between(const BodyModel& model, const OrificeDefinition& orifice, const Eigen::Vector3d& gravity,
                  const Eigen::VectorXd& pressure) {
  const Eigen::VectorXd at_origin = pressures_at_origin(model, gravity, pressure);
  return orifice_flow(orifice.discharge, orifice.area, model.definition.fluid.density,
                      at_origin[orifice.from] - at_origin[orifice.to]);
}

Eigen::VectorXd enclosed_volumes(const BodyModel& model, const Eigen::VectorXd& position) {
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.chambers.size()));
  for (std::size_t t = 0; t < model.chamber.size(); ++t) {
    if (model.chamber[t] < 0) continue;
    volumes[model.chamber[t]] += model.share[t] * volume_of(corners_of(model.surface[t], position));
  }
  if (!model.has_fluid()) return volumes;
  for (const OpeningModel& opening : model.openings) {
    volumes[opening.chamber] += lip_cap_of(opening.at(position)).volume;
  }
  for (std::size_t c = 0; c < model.chambers.size(); ++c) {
    volumes[static_cast<Eigen::Index>(c)] += model.chambers[c].beyond_caps;
  }
  return volumes;
}

}  // namespace thinwall
