#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/contact/ToolSolid.hpp"
#include "engine/equilibrium/BodyModel.hpp"
#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/tool/Tool.hpp"

namespace thinwall {

/// Where the wall and the tools are as one solution sets out.
struct WayStart {
  std::vector<ToolSolid> solids = {};                // those of all tools
  std::vector<char> guarded = {};                    // (solids), whether nothing may go through them at once
  Eigen::VectorXd position = {};                     // (unknowns), metres
  std::vector<std::span<const double>> forces = {};  // (solids x sites), newton
};

/// Whether nothing may go through a solid at once: a ball, a rod or a plate, or the point of a needle, but for one in a
/// wall on its way back, which is drawn through its hole. `solids`: those of all tools, parts after what they are of.
bool is_guarded(ToolKind kind, std::span<const ToolSolid> solids, std::size_t solid, const ToolSolid& after,
                bool is_in_wall);

/// Whether a place of the wall on its straight way to `position` (unknowns, metres) comes so deep into a guarded solid
/// that it did not slide around it but went through. The problem's solids are where the tools are afterwards.
bool jumped_over_tools(const BodyModel& model, const WayStart& start, const EquilibriumProblem& problem,
                       const Eigen::VectorXd& position);

/// What goes on from a solution while the tools stand. Looks into the problem, which must outlast it.
WayStart going_on(const WayStart& way, const EquilibriumProblem& problem, const Eigen::VectorXd& position);

}  // namespace thinwall
