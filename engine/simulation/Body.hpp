#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/simulation/BodyModel.hpp"
#include "engine/simulation/Equilibrium.hpp"
#include "engine/simulation/Newton.hpp"
#include "engine/simulation/SimulationOptions.hpp"
#include "engine/tool/FirstContact.hpp"
#include "engine/tool/Tool.hpp"

namespace thinwall {

/// Energies in joule. The books close: stored + numerical = tool work + script work.
struct EnergyBooks {
  double elastic = 0;      // stored in the wall
  double kinetic = 0;      // stored in the wall's motion
  double fluid = 0;        // stored in a compressible fluid
  double contact = 0;      // stored in the potential between wall and tools
  double numerical = 0;    // spent by the integrator, since time zero
  double tool_work = 0;    // put in by the tools, since time zero
  double script_work = 0;  // put in by filling and stretching before time zero

  double stored() const { return elastic + kinetic + fluid + contact; }
  double imbalance() const { return stored() + numerical - tool_work - script_work; }
};

/// A body in motion: what changes from step to step.
struct BodyState {
  EquilibriumState equilibrium;
  Eigen::VectorXd velocity;           // (3 vertices), metres / second
  Eigen::VectorXd acceleration;       // (3 vertices), metres / second^2
  Eigen::VectorXd previous_position;  // (3 vertices), a step earlier
  Eigen::VectorXd previous_velocity;  // (3 vertices), a step earlier
  double previous_step = 0;           // seconds between the two; zero when there is no earlier step
  Eigen::VectorXd static_force;       // (3 vertices), newton: gradient of wall and contact less pressure
  double volume = 0;                  // metres^3
  double fluid_volume = 0;            // metres^3
  double reference_pressure = 0;      // pascal, at which a compressible fluid has its volume
  std::vector<Attachment> attachments;
  std::vector<ToolContact> contacts;               // (tools)
  std::vector<std::vector<double>> sphere_forces;  // (tools x triangles), newton, zero for tools that are no spheres
  EnergyBooks books;
};

/// What the last step took.
struct BodyStepReport {
  int newton_iterations = 0;
  int shifted_iterations = 0;
  int halvings = 0;     // how often the step was divided
  double residual = 0;  // newton
};

/// Energy of a compressible fluid from its volume at the reference pressure, joule; zero for others.
double fluid_energy(const BodyModel& model, const BodyState& state);

/// A sphere tool: its tip is the point of the ball farthest along the direction.
SphereTool sphere_at(const ToolDefinition& tool, const ToolPose& pose);

/// One body with its solver. Not copyable; bodies do not touch each other.
class Body {
 public:
  Body(BodyDefinition definition, std::vector<ToolDefinition> tools, SimulationOptions options);

  /// Finds the equilibrium before time zero under the given pressure and prestretch. Throws SimulationFailure.
  void settle();

  /// Moves the tools from one set of poses to the next, (tools) each, and brings the body there in `duration` seconds.
  /// Throws SimulationFailure when the step cannot be saved; the state is then the one before.
  void advance(std::span<const ToolPose> begin, std::span<const ToolPose> end, double duration);

  /// Changes the volume of the fluid, metres^3, from the next step on; what that puts in is booked as the script's
  /// work. Asserts that there is a fluid.
  void set_fluid_volume(double volume);

  const BodyModel& model() const { return *model_; }
  const BodyState& state() const { return state_; }
  const BodyStepReport& report() const { return report_; }
  SurfaceView surface() const;

  /// Pressure between wall and tools at each vertex, (vertices), pascal: force on the vertex over its rest area.
  Eigen::VectorXd contact_pressure() const;

 private:
  NewtonResult solve(EquilibriumProblem& problem, EquilibriumState& state);
  NewtonResult relax(EquilibriumProblem& problem, EquilibriumState& state);
  void solve_statics(double pressure, FluidMode mode);
  bool try_step(std::span<const ToolPose> begin, std::span<const ToolPose> end, double duration);
  void attach(std::span<const ToolPose> begin, std::span<const ToolPose> end, EquilibriumProblem& problem) const;
  void attach_line(int tool, const ToolPose& end, EquilibriumProblem& problem) const;
  bool release(std::span<const ToolPose> poses, EquilibriumProblem& problem) const;
  void add_spheres(std::span<const ToolPose> poses, EquilibriumProblem& problem) const;
  void add_inertia(double duration, EquilibriumProblem& problem) const;
  void accept(std::span<const ToolPose> begin, double duration, const EquilibriumProblem& problem,
              const EquilibriumState& reached);
  void update_velocity(const BodyState& before, double duration, const EquilibriumProblem& problem);
  void update_forces(const EquilibriumProblem& problem);
  void update_books(const BodyState& before, std::span<const ToolPose> begin, const EquilibriumProblem& problem);
  FluidMode fluid_mode() const;

  std::unique_ptr<const BodyModel> model_;
  std::vector<ToolDefinition> tools_;
  SimulationOptions options_;
  Newton newton_;
  BodyState state_;
  BodyStepReport report_;
  std::string failure_;  // why the last attempt failed
};

}  // namespace thinwall
