#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/equilibrium/BodyModel.hpp"
#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/simulation/BodyState.hpp"
#include "engine/simulation/PassedTools.hpp"
#include "engine/tool/Tool.hpp"

namespace thinwall {

/// What tools do to a wall in a step: what they take hold of, press on, go through and let go. Looks at the body, from
/// whose state the step sets out, and at the tools, and must not outlive them. Of all that follows `begin`, `end`:
/// (tools), where the tools set out and get to.
class StepContacts {
 public:
  StepContacts(const BodyModel& model, const BodyState& state, std::span<const ToolDefinition> tools)
      : model_(model), state_(state), tools_(tools) {}

  /// The largest part of a step in which no solid of a tool that is near the wall moves so far that what it touched
  /// could leave it through its other side.
  double largest_part(std::span<const ToolPose> begin, std::span<const ToolPose> end) const;

  /// Adds the solids with the forces that they have, and what of the wall tools go through unfelt.
  void add_solids(std::span<const ToolPose> end, EquilibriumProblem& problem) const;
  /// Adds needles that are in punctures, what is free on them, and the openings that they keep shut.
  void add_shafts(std::span<const ToolPose> end, EquilibriumProblem& problem) const;
  /// Lets points and lines hold what they held, and take hold of what they come upon. Throws SimulationFailure where
  /// nothing of that may move.
  void attach(std::span<const ToolPose> begin, std::span<const ToolPose> end, EquilibriumProblem& problem) const;
  /// Throws SimulationFailure where a solid stands in a place of the wall that cannot give way along its normal.
  void refuse_held_places(const EquilibriumProblem& problem) const;
  /// Where wall and tools set out; the problem has the solids at the end.
  WayStart way(std::span<const ToolPose> begin, const EquilibriumProblem& problem) const;

  /// Takes off what points and lines would have to pull after them in a solution; whether there is any.
  bool release(std::span<const ToolPose> end, EquilibriumProblem& problem) const;
  /// Lets flat tools keep edges out too where one has come past their rims; whether there is any. `reached`:
  /// (unknowns), metres.
  bool catch_passed_edges(EquilibriumProblem& problem, const Eigen::VectorXd& reached) const;

  /// Whether a tool that passes what is held in its way, a needle or a blade, is out of it again.
  bool is_out_of_wall(int tool, const ToolPose& pose) const;

 private:
  void attach_line(int tool, const ToolPose& begin, const ToolPose& end, EquilibriumProblem& problem) const;
  void add_passed(std::span<const ToolPose> end, EquilibriumProblem& problem) const;
  SurfaceView surface() const { return surface_of(model_, state_); }

  const BodyModel& model_;
  const BodyState& state_;
  std::span<const ToolDefinition> tools_;
};

}  // namespace thinwall
