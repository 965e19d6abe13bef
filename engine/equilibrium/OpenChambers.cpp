#include "engine/equilibrium/OpenChambers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/equilibrium/SideBySide.hpp"
#include "engine/fluid/FluidWeight.hpp"
#include "engine/fluid/PressedLanes.hpp"

namespace thinwall {
namespace {

/// Part of a motion by whose central difference the load on a cap is differentiated: it is a cubic.
constexpr double kDifference = 1e-3;

/// Mean edges that a free surface stands above the middle of an opening when the speed at which fluid comes to the lips
/// counts in full. Were it none, a flow would begin at once as the surface reaches the lips, and the surface at the end
/// of a step could have no place.
constexpr double kFullApproachHeight = 0.5;

/// Pressure of the contents of a chamber under their weight, and what their inertia adds: that of a fluid below a
/// surface is taken to be spread over the whole chamber. Without a surface `weight` holds the sum of both.
struct ContentsPressure {
  PressureField weight, inertia;
};

PressureField weight_field(const BodyModel& model, const EquilibriumProblem& problem, int chamber, double pressure) {
  if (problem.fluids[chamber].is_empty) return {};
  const Eigen::Vector3d slope = model.definition.fluid.density * problem.gravity;
  return {.at_origin = pressure - slope.dot(model.chambers[chamber].level),
          .slope = slope,
          .suction = !problem.fluids[chamber].has_surface};
}

ContentsPressure contents_pressure(const BodyModel& model, const EquilibriumProblem& problem,
                                   const EquilibriumTerms& terms, int chamber, double pressure) {
  ContentsPressure contents{.weight = weight_field(model, problem, chamber, pressure), .inertia = {}};
  if (problem.fluid_inertia.empty()) return contents;
  const FluidInertia& inertia = problem.fluid_inertia[chamber];
  const Eigen::Vector3d push = inertia.factor * (terms.moment.col(chamber) - inertia.target);
  contents.inertia = {.at_origin = push.dot(inertia.origin), .slope = -push};
  if (contents.weight.suction) {
    contents.weight.at_origin += contents.inertia.at_origin;
    contents.weight.slope += contents.inertia.slope;
    contents.inertia = {};
  }
  return contents;
}

/// Adds (3 x lips) to a vector of the (unknowns).
template <typename Vector>
void add_to_lips(const OpeningModel& opening, const Eigen::Matrix3Xd& part, Vector&& whole) {
  for (std::size_t k = 0; k < opening.lips.size(); ++k) {
    whole.template segment<3>(3 * opening.lips[k]) += part.col(static_cast<Eigen::Index>(k));
  }
}

void add_to_corners(const Eigen::Vector3i& triangle, const Eigen::Matrix<double, 9, 1>& part, auto&& whole) {
  for (int k = 0; k < 3; ++k) whole.template segment<3>(3 * triangle[k]) += part.segment<3>(3 * k);
}

void add_caps(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
              EquilibriumTerms& terms) {
  for (std::size_t c = 0; c < model.chambers.size(); ++c) {
    terms.volume[static_cast<Eigen::Index>(c)] += model.chambers[c].beyond_caps;
  }
  for (const OpeningModel& opening : model.openings) {
    const int c = opening.chamber;
    const Eigen::Matrix3Xd lips = opening.at(position);
    terms.lips.push_back(lip_cap_of(lips));
    terms.volume[c] += terms.lips.back().volume;
    add_to_lips(opening, terms.lips.back().volume_gradient, terms.volume_gradient.col(c));
    if (!problem.gravity.isZero() && !problem.fluids[c].has_surface) {
      const LipMoment moment = lip_moment_of(lips.colwise() - model.chambers[c].level);
      terms.gravity -= model.definition.fluid.density * problem.gravity.dot(moment.value);
    }
    if (problem.fluid_inertia.empty()) continue;
    const LipMoment moment = lip_moment_of(lips.colwise() - problem.fluid_inertia[c].origin);
    terms.moment.col(c) += moment.value;
    for (int axis = 0; axis < 3; ++axis) {
      add_to_lips(opening, moment.gradient[axis], terms.moment_gradient.col(3 * c + axis));
    }
  }
}

/// What is below the free surface of chambers that have one: its volume, from Archimedes' principle over the closed
/// surface, with its derivatives, and its energy in gravity, pressure V - integral of the pressure.
void add_filled(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                const Eigen::VectorXd& pressure, EquilibriumTerms& terms) {
  terms.filled = terms.volume;
  terms.filled_by_pressure.setZero(terms.volume.size());
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    if (!problem.fluids[c].has_surface || problem.fluids[c].is_empty) continue;
    const PressureField field = weight_field(model, problem, c, pressure[c]);
    Eigen::Vector3d load = Eigen::Vector3d::Zero(), unit = load, squared = load;
    terms.volume_gradient.col(c).setZero();
    double share = 1;  // of the triangle that is added
    const auto add = [&](const std::array<Eigen::Vector3d, 3>& corners) -> Eigen::Matrix<double, 9, 1> {
      const PressedTriangle pressed(corners, field);
      const auto part = pressed.load(), one = pressed.unit_load();
      for (int k = 0; k < 3; ++k) load += share * part.segment<3>(3 * k), unit += share * one.segment<3>(3 * k);
      squared += share * pressed.squared_load();
      return share * one;
    };
    for (std::size_t t = 0; t < model.surface.size(); ++t) {
      if (model.chamber[t] != c) continue;
      share = model.share[t];
      add_to_corners(model.surface[t], add(corners_of(model.surface[t], position)), terms.volume_gradient.col(c));
    }
    share = 1;
    for (const OpeningModel& opening : model.openings) {
      if (opening.chamber != c) continue;
      add_to_lips(opening, lip_sum_of(opening.at(position), add), terms.volume_gradient.col(c));
    }
    const Eigen::Vector3d along = field.slope / field.slope.squaredNorm();
    terms.filled[c] = load.dot(along);
    terms.filled_by_pressure[c] = unit.dot(along);
    terms.gravity += pressure[c] * terms.filled[c] - squared.dot(along);
  }
}

/// What the contents of open chambers do to kLanes triangles.
struct ContentsLanes {
  PressedLanes pressed;
  double moments[3][9][kLanes];  // newton, of the fields that have a unit of slope along an axis
};

/// Leaves as much of one lane as a triangle has a share in what encloses the contents.
void leave_share(double share, bool with_hessian, bool with_moments, int lane, ContentsLanes& part) {
  for (int k = 0; k < 9; ++k) {
    part.pressed.load[k][lane] *= share;
    part.pressed.unit_load[k][lane] *= share;
    for (int axis = 0; axis < 3 && with_moments; ++axis) part.moments[axis][k][lane] *= share;
    for (int block = 0; block < 6 && with_hessian; ++block) part.pressed.stiffness[block][k][lane] *= share;
  }
}

bool is_below_opening(const BodyModel& model, int triangle) {
  return model.chamber[triangle] >= 0 && model.is_open(model.chamber[triangle]);
}

/// Of the triangles from `first` on. `moments` only where contents leak and have inertia.
void find_contents_terms(const BodyModel& model, const EquilibriumProblem& problem,
                         const std::vector<ContentsPressure>& contents, const Eigen::VectorXd& position,
                         bool with_hessian, int first, ContentsLanes& part) {
  double corners[9][kLanes] = {}, origins[3][kLanes] = {};
  const int count = gather_corners(model.surface, position, first, corners);
  PressureLanes weight, inertia;
  bool is_any_below = false, has_surface = false;
  for (int lane = 0; lane < count; ++lane) {
    if (!is_below_opening(model, first + lane)) continue;
    const int chamber = model.chamber[first + lane];
    weight.set(lane, contents[chamber].weight);
    inertia.set(lane, contents[chamber].inertia);
    is_any_below = true;
    has_surface = has_surface || !contents[chamber].weight.suction;
    for (int k = 0; k < 3 && !problem.fluid_inertia.empty(); ++k) {
      origins[k][lane] = problem.fluid_inertia[chamber].origin[k];
    }
  }
  if (!is_any_below) return;
  pressed_lanes(corners, weight, with_hessian, part.pressed);
  if (problem.fluid_inertia.empty()) return;
  if (has_surface) {
    PressedLanes pushed;
    pressed_lanes(corners, inertia, with_hessian, pushed);
    add_to(part.pressed, pushed, with_hessian);
  }
  if (!model.definition.fluid.leaks) return;
  for (int k = 0; k < 9; ++k) {
    for (int lane = 0; lane < kLanes; ++lane) corners[k][lane] -= origins[k % 3][lane];
  }
  moment_loads_of(corners, part.moments);
}

void add_contents_terms(const BodyModel& model, int triangle, double pressure, const ContentsLanes& part, int lane,
                        EquilibriumTerms& terms) {
  const int chamber = model.chamber[triangle];
  const Eigen::Vector3i& corners = model.surface[triangle];
  if (model.definition.fluid.leaks) {
    for (int axis = 0; axis < 3 && terms.moment_load.cols() > 0; ++axis) {
      scatter_lane(corners, part.moments[axis], lane, 1, terms.moment_load.col(3 * chamber + axis).data());
    }
    scatter_lane(corners, part.pressed.unit_load, lane, 1, terms.pressure_load.col(chamber).data());
  }
  for (int k = 0; k < 9; ++k) {
    const double load = part.pressed.load[k][lane];
    // The part of a pascal times the pressure comes from the columns.
    terms.gradient[3 * corners[k / 3] + k % 3] += pressure * part.pressed.unit_load[k][lane] - load;
    terms.largest_force = std::max(terms.largest_force, std::abs(load));
  }
  if (terms.has_hessian()) {
    add_triangle(model.addresses[triangle], &part.pressed.stiffness[0][0][lane], kLanes, terms.values);
  }
}

void add_loads(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
               const Eigen::VectorXd& pressure, EquilibriumTerms& terms) {
  std::vector<ContentsPressure> contents;
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    contents.push_back(contents_pressure(model, problem, terms, c, pressure[c]));
  }
  thread_local std::vector<ContentsLanes> buffer;
  const int triangles = static_cast<int>(model.surface.size());
  for_each((triangles + kLanes - 1) / kLanes, kTrianglesAtOnce / kLanes, buffer,
           [&](int group, ContentsLanes& part) {
             const int first = kLanes * group, end = std::min(first + kLanes, triangles);
             find_contents_terms(model, problem, contents, position, terms.has_hessian(), first, part);
             const bool moves = model.definition.fluid.leaks && !problem.fluid_inertia.empty();
             for (int t = first; t < end; ++t) {
               if (model.share[t] == 1 || !is_below_opening(model, t)) continue;
               leave_share(model.share[t], terms.has_hessian(), moves, t - first, part);
             }
           },
           [&](int group, const ContentsLanes& part) {
             const int first = kLanes * group, end = std::min(first + kLanes, triangles);
             for (int t = first; t < end; ++t) {
               if (!is_below_opening(model, t)) continue;
               add_contents_terms(model, t, pressure[model.chamber[t]], part, t - first, terms);
             }
           });
  for (const OpeningModel& opening : model.openings) {
    const Eigen::Matrix3Xd lips = opening.at(position);
    const ContentsPressure& of = contents[opening.chamber];
    const Eigen::Matrix3Xd load = lip_load_of(lips, of.weight) + lip_load_of(lips, of.inertia);
    if (model.definition.fluid.leaks) {
      add_to_lips(opening, load, terms.lip_force);
    } else {
      add_to_lips(opening, pressure[opening.chamber] * lip_load_of(lips, {.at_origin = 1}) - load, terms.gradient);
    }
  }
}

}  // namespace

void add_open_chambers(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                       const Eigen::VectorXd& pressure, EquilibriumTerms& terms) {
  if (!model.has_open_chambers()) return;
  add_caps(model, problem, position, terms);
  add_filled(model, problem, position, pressure, terms);
  // Closed chambers share the columns: there both are the same.
  terms.pressure_load = terms.volume_gradient;
  terms.moment_load = terms.moment_gradient;
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    if (!model.is_open(c) || !model.definition.fluid.leaks) continue;
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

std::vector<int> rim_unknowns(const BodyModel& model) {
  std::vector<int> unknowns;
  if (!model.has_open_chambers()) return unknowns;
  for (const OpeningModel& opening : model.openings) {
    for (const int vertex : opening.lips) unknowns.insert(unknowns.end(), {3 * vertex, 3 * vertex + 1, 3 * vertex + 2});
  }
  std::ranges::sort(unknowns);
  unknowns.erase(std::ranges::unique(unknowns).begin(), unknowns.end());
  return unknowns;
}

Eigen::VectorXd rim_forces(const BodyModel& model, const EquilibriumProblem& problem, const EquilibriumTerms& terms,
                           const Eigen::VectorXd& position, const Eigen::VectorXd& pressure,
                           const Eigen::VectorXd& motion) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(position.size());
  for (const OpeningModel& opening : model.openings) {
    const ContentsPressure contents =
        contents_pressure(model, problem, terms, opening.chamber, pressure[opening.chamber]);
    if (!model.definition.fluid.leaks) {
      const Eigen::Matrix3Xd lips = opening.at(position), moved = kDifference * opening.at(motion);
      for (const PressureField& field : {contents.weight, contents.inertia}) {
        const Eigen::Matrix3Xd change = lip_load_of(lips + moved, field) - lip_load_of(lips - moved, field);
        add_to_lips(opening, change / (2 * kDifference), forces);
      }
    }
    for (std::size_t k = 0; k < opening.lips.size(); ++k) {
      const int first = opening.lips[k], second = opening.lips[(k + 1) % opening.lips.size()];
      for (const PressureField& field : {contents.weight, contents.inertia}) {
        const auto change = rim_load_change({position.segment<3>(3 * first), position.segment<3>(3 * second)},
                                            {motion.segment<3>(3 * first), motion.segment<3>(3 * second)}, field);
        forces.segment<3>(3 * first) += change[0];
        forces.segment<3>(3 * second) += change[1];
      }
    }
  }
  return forces;
}

double lip_pressure(const BodyModel& model, const EquilibriumProblem& problem, const EquilibriumTerms& terms,
                    int opening, const Eigen::VectorXd& pressure) {
  const int chamber = model.openings[opening].chamber;
  const Eigen::Vector3d height = terms.lips[opening].center - model.chambers[chamber].level;
  return pressure[chamber] + model.definition.fluid.density * problem.gravity.dot(height);
}

Flow outflow(const BodyModel& model, const EquilibriumProblem& problem, int opening, double area, double lip_pressure) {
  const FluidDefinition& fluid = model.definition.fluid;
  const Flow whole =
      approached_orifice_flow(fluid.discharge, area, fluid.density, lip_pressure, problem.approach_to(opening));
  if (!problem.fluids[model.openings[opening].chamber].has_surface) return whole;
  if (lip_pressure <= 0) return {};
  const double full = fluid.density * problem.gravity.norm() * kFullApproachHeight * model.edge_length;
  if (lip_pressure >= full) return whole;
  const Flow even = orifice_flow(fluid.discharge, area, fluid.density, lip_pressure);
  const double part = lip_pressure / full;
  return {.rate = even.rate + part * (whole.rate - even.rate),
          .slope = even.slope + part * (whole.slope - even.slope) + (whole.rate - even.rate) / full};
}

OpeningEquation opening_equation(const BodyModel& model, const EquilibriumProblem& problem,
                                 const EquilibriumTerms& terms, int chamber, const Eigen::VectorXd& position,
                                 const Eigen::VectorXd& pressure, bool with_derivatives) {
  const FluidProblem& fluid = problem.fluids[chamber];
  OpeningEquation equation;
  // The fluid that leaves would have filled less space than at the pressure at which it is counted.
  const double at = pressure[chamber];
  const double yielding = fluid.bulk_pressure(at) == at ? fluid.yielding() : 0;  // 1 / pascal
  const double held = fluid.held(at);
  if (with_derivatives) equation.by_position.setZero(position.size());
  for (int k = 0; k < static_cast<int>(model.openings.size()); ++k) {
    const OpeningModel& opening = model.openings[k];
    if (opening.chamber != chamber || (fluid.vent >= 0 && fluid.vent != k)) continue;
    const double at_lips = lip_pressure(model, problem, terms, k, pressure);
    const Eigen::Vector3d slope =
        model.definition.fluid.density * problem.gravity / static_cast<double>(opening.lips.size());
    Eigen::Matrix3Xd by_lips;
    if (fluid.vent >= 0) {
      equation.value += fluid.vent_compliance * at_lips;
      equation.by_pressure += fluid.vent_compliance;
      if (with_derivatives) by_lips = (fluid.vent_compliance * slope).replicate(1, opening.lips.size());
    } else {
      const Eigen::Vector3d& area = terms.lips[k].area;
      if (problem.is_sealed(k)) continue;
      const Flow flow = outflow(model, problem, k, area.norm(), at_lips);
      equation.value += fluid.outflow_time * flow.rate * held;
      equation.by_pressure += fluid.outflow_time * (flow.slope * held - flow.rate * yielding);
      if (with_derivatives) {
        const double by_area = fluid.outflow_time * outflow(model, problem, k, 1, at_lips).rate * held;
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
