#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/contact/ToolSolid.hpp"
#include "engine/equilibrium/BodyModel.hpp"
#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/equilibrium/FrictionContact.hpp"
#include "engine/equilibrium/FrictionMixing.hpp"
#include "engine/simulation/BodyState.hpp"
#include "engine/tool/Tool.hpp"

namespace thinwall {

bool has_friction(std::span<const ToolDefinition> tools);

/// Finds Coulomb's friction between a wall and tools in a step: solution after solution, until one asks for the
/// friction that it was found with. Looks at model, state, from which the step sets out, and tools, and must not
/// outlive them.
class FrictionSearch {
 public:
  /// `begin`: (tools), at the beginning of the step.
  FrictionSearch(const BodyModel& model, const BodyState& state, std::span<const ToolDefinition> tools,
                 std::span<const ToolPose> begin);

  /// What the first solution is to be found with: that of the forces in the problem, where the wall is now.
  std::vector<FrictionContact> first(const EquilibriumProblem& problem) const;

  /// Whether a solution asks for other friction than its problem has, which is revised then. `reached`: (unknowns),
  /// metres. `motion`: metres, that the solution has moved the wall by at most.
  bool revise(EquilibriumProblem& problem, const Eigen::VectorXd& reached, double motion);

  /// Whether it has been revised so often that it will not be found.
  bool is_hopeless() const;

 private:
  /// `at_begin`: whether the tools are taken to be where they set out. `position`: (unknowns), metres.
  std::vector<FrictionContact> contacts(const EquilibriumProblem& problem, bool at_begin,
                                        const Eigen::VectorXd& position) const;

  const BodyModel& model_;
  const BodyState& state_;
  std::span<const ToolDefinition> tools_;
  std::vector<ToolSolid> begin_;  // (solids of all tools)
  FrictionMixing mixing_;
  int turns_ = 0;  // how often a solution has been asked
};

/// Adds what friction does to tools and their solids to the contacts of a state at the end of a step.
void add_friction_forces(const BodyModel& model, const EquilibriumProblem& problem, BodyState& state);

/// Lets a state at the end of a step remember its friction. What friction has spent since `before`, joule, by the
/// trapezoidal rule. `begin`: (solids of all tools), at the beginning of the step.
double remember_friction(const BodyModel& model, const BodyState& before, std::span<const ToolSolid> begin,
                         const EquilibriumProblem& problem, BodyState& state);

}  // namespace thinwall
