#pragma once

#include "engine/tool/Tool.hpp"

namespace thinwall {

/// The frame of a tool: x', y', z' as columns.
Eigen::Matrix3d frame_of(const ToolPose& pose);

/// Poses between two: tip and opening straight, the frame by the shortest turn, at an even rate about one axis (as the
/// spherical linear interpolation of quaternions does; Shoemake, SIGGRAPH 1985). Half a turn goes in the positive sense
/// about that of the tool's axes which is nearest to the turn's. `part` from 0 to 1.
ToolPose between(const ToolPose& begin, const ToolPose& end, double part);

/// The pose turned the shortest way until z' is `direction`, a unit vector. Where that is opposite it turns about y'.
ToolPose turned_to(const ToolPose& pose, const Eigen::Vector3d& direction);

}  // namespace thinwall
