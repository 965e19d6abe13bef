#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "engine/contact/ToolSolid.hpp"
#include "engine/equilibrium/BodyModel.hpp"
#include "engine/mesh/SurfacePoint.hpp"

namespace thinwall {

/// (vertices), whether a vertex cannot move along a direction: whether all axes that the direction has a part along are
/// fixed there.
std::vector<char> held_against(const BodyModel& model, const Eigen::Vector3d& direction);

/// Whether a wall is flat across an axis and held along it all over, as one that is to stay in plane stress: it cannot
/// wrinkle.
bool is_held_in_its_plane(const BodyModel& model);

/// (sites), which parts of the wall cannot make way for a needle or a blade: vertices, edges and triangles all of whose
/// vertices are held, and those that hang on such a vertex or edge which the tool has come to. `position`: (unknowns),
/// metres; `held`: (vertices).
std::vector<char> sites_in_the_way(const BodyModel& model, const Eigen::VectorXd& position, const ToolSolid& tool,
                                   const std::vector<char>& held);

/// Where a segment goes through a triangle that has a held corner: the first along the segment; nothing where it goes
/// through none, or through free ones alone. `position`: (unknowns), metres; `held`: (vertices); `is_free`:
/// (triangles).
std::optional<SurfacePoint> held_crossing(const BodyModel& model, const Eigen::VectorXd& position,
                                          const Eigen::Vector3d& begin, const Eigen::Vector3d& end,
                                          const std::vector<char>& held, const std::vector<char>& is_free);

}  // namespace thinwall
