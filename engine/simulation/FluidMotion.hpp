#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/equilibrium/BodyModel.hpp"
#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/fluid/PressureLoad.hpp"

namespace thinwall {

struct BodyState;

/// How the fluid of a chamber moves: its first moment, the integral of x over the volume, and its rates.
struct FluidMotion {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();             // metres^4
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();           // metres^4 / second
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();       // metres^4 / second^2
  Eigen::Vector3d previous_moment = Eigen::Vector3d::Zero();    // metres^4, a step earlier
  Eigen::Vector3d previous_velocity = Eigen::Vector3d::Zero();  // metres^4 / second, a step earlier
  double volume = 0;                                            // metres^3, of the chamber
  double previous_volume = 0;                                   // metres^3, a step earlier
};

/// Whether the fluid of a chamber may leave it through openings.
inline bool may_leak(const BodyModel& model, int chamber) {
  return model.is_open(chamber) && model.definition.fluid.leaks;
}

/// Integral of x, from its level, over each chamber, (3 x chambers), metres^4.
Eigen::Matrix3Xd first_moments(const BodyModel& model, const Eigen::VectorXd& position);

/// Where the moments of the fluid in a chamber count from, metres: its level, or its lips where it runs out.
Eigen::Vector3d moment_origin(const BodyModel& model, const BodyState& state, int chamber);

/// Mass of the fluid in a chamber over the square of the volume that it moves with, kg / metre^6: beside air that is
/// the whole of the contents.
double moment_mass(const BodyModel& model, const BodyState& state, int chamber);

/// What the inertia of its fluid adds to the pressure in a chamber.
PressureField pressure_of_inertia(const BodyModel& model, const BodyState& state, int chamber);

/// Fluid at rest in the chambers as they are, (chambers).
std::vector<FluidMotion> fluid_at_rest(const BodyModel& model, const BodyState& state);

/// What the inertia of the fluid, (chambers), asks for at the end of a step from a state, by the second-order backward
/// difference; none where it has no motion. `duration`: seconds.
std::vector<FluidInertia> fluid_inertia_over(const BodyModel& model, const BodyState& state, double duration);

/// The same of a state as it is, without a step: where the chambers are it pushes as it does there.
std::vector<FluidInertia> fluid_inertia_now(const BodyModel& model, const BodyState& state);

/// Lets the fluid of a state come along with its chambers, which have their volumes at the end of a step already.
/// `moments`: (3 x chambers), metres^4, at the end, from the origins of `inertia`, that the step was found with.
/// `duration`, `previous_step`: seconds, see BackwardDifference.
void move_fluid(const BodyModel& model, const Eigen::Matrix3Xd& moments, std::span<const FluidInertia> inertia,
                double duration, double previous_step, BodyState& state);

/// Joule, all chambers.
double fluid_kinetic_energy(const BodyModel& model, const BodyState& state);

}  // namespace thinwall
