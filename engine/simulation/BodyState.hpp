#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/equilibrium/BodyModel.hpp"
#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/equilibrium/Newton.hpp"
#include "engine/simulation/CutProgress.hpp"
#include "engine/simulation/FlowMemory.hpp"
#include "engine/simulation/FluidMotion.hpp"
#include "engine/simulation/Puncture.hpp"
#include "engine/simulation/WallHistory.hpp"
#include "engine/tool/FirstContact.hpp"

namespace thinwall {

/// Energies in joule. The books close: stored + spent = tool work + script work.
struct EnergyBooks {
  double elastic = 0;      // stored in the wall; of a viscous one what it keeps for good
  double bending = 0;      // stored in the bending of a shell
  double kinetic = 0;      // stored in the motion of wall and fluid
  double fluid = 0;        // stored in a compressible fluid
  double gravity = 0;      // stored in the height of wall and fluid, of what has leaked in that of the opening
  double contact = 0;      // stored in the potentials between wall and tools, wall and wall, wall and floor
  double viscous = 0;      // spent by viscosity, damping and orifices since time zero; Prony terms give part of it back
  double friction = 0;     // spent by friction, since time zero
  double leak = 0;         // spent in the jets of fluid that leaves, since time zero: pressure work and motion
  double fracture = 0;     // spent on new cut area, since time zero
  double jump = 0;         // spent where the wall gave way by more than that, since time zero
  double numerical = 0;    // spent by the integrator, since time zero
  double tool_work = 0;    // put in by the tools, since time zero
  double script_work = 0;  // put in by loads and filling, and by filling and stretching before time zero

  double stored() const { return elastic + bending + kinetic + fluid + gravity + contact; }
  double spent() const { return viscous + friction + leak + fracture + jump + numerical; }
  double imbalance() const { return stored() + spent() - tool_work - script_work; }
  double largest() const;  // of the terms, the integrator's aside
};

/// A body in motion: what changes from step to step.
struct BodyState {
  EquilibriumState equilibrium;
  Eigen::VectorXd velocity;           // (unknowns), metres / second
  Eigen::VectorXd acceleration;       // (unknowns), metres / second^2
  Eigen::VectorXd previous_position;  // (unknowns), a step earlier
  Eigen::VectorXd previous_velocity;  // (unknowns), a step earlier
  double previous_step = 0;           // seconds between the two; zero when there is no earlier step
  Eigen::VectorXd static_force;       // (unknowns), newton: gradient of wall and contact less pressure
  Eigen::VectorXd load_force;         // (unknowns), newton
  std::vector<double> load_factors;   // (loads)
  WallHistory wall;
  std::vector<FluidMotion> fluid_motion;  // (chambers)
  Eigen::VectorXd volume;                 // (chambers), metres^3
  Eigen::VectorXd fluid_volume;           // (chambers), metres^3
  Eigen::VectorXd reference_pressure;     // (chambers), pascal, at which a compressible fluid has its volume
  Eigen::VectorXd leaked;                 // (chambers), metres^3, out through openings since time zero
  Eigen::VectorXd air;                    // (chambers), metres^3, that came in
  Eigen::VectorXd open_area;              // (openings), metres^2, above 0 but where a needle keeps one shut
  FlowMemory outflow;                     // (openings)
  FlowMemory exchange;                    // (orifices)
  double leaked_gravity = 0;              // joule, of what has leaked, each part at its opening's height
  std::vector<Attachment> attachments;
  std::vector<ToolContact> contacts;                  // (tools)
  std::vector<ToolContact> solid_contacts;            // (solids of all tools, in their order)
  std::vector<std::vector<double>> solid_forces;      // (solids x sites), newton
  std::vector<std::vector<FrictionMemory>> friction;  // (solids), in the order of the sites
  double friction_energy = 0;                         // joule, stored in the elastic slip
  CutProgress cut;
  double drag = 0;             // over the wall's stiffness, what slows a slack cut wall, see Body::creep
  bool drag_eases = true;      // whether the step before was easy enough for less of it
  Eigen::VectorXd drag_force;  // (unknowns) or none, newton, on the wall
  std::vector<Puncture> punctures;
  std::vector<Pressing> pressing;  // (tools)
  std::vector<int> piercing;  // tools, ascending: needles that pierce, or are not yet out of what they have pierced
  std::vector<int> incising;  // the same of blades
  EnergyBooks books;
};

/// What a compressible fluid in a chamber is under, pascal.
inline double bulk_pressure_of(const BodyState& state, int chamber) {
  const double pressure = state.equilibrium.pressure[chamber];
  return state.air[chamber] > 0 ? bulk_pressure_beside_air(pressure) : pressure;
}

/// Energy of a compressible fluid from its volume at the reference pressure, joule, all chambers; zero for others.
double fluid_energy(const BodyModel& model, const BodyState& state);

/// The wall as it is now. What it refers to are model and state.
inline SurfaceView surface_of(const BodyModel& model, const BodyState& state) {
  return {
      .triangles = model.definition.mesh.triangles, .position = state.equilibrium.position, .open = !model.has_fluid()};
}

}  // namespace thinwall
