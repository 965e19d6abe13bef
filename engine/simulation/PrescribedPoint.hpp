#pragma once

#include <Eigen/Core>

#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/tool/Tool.hpp"

namespace thinwall {

/// Point of a tool at `pose` that holds a material point, metres.
Eigen::Vector3d holding_point(const Attachment& attachment, const ToolPose& pose);

/// Where a tool at `pose` wants the material point that it holds, metres.
Eigen::Vector3d prescribed_point(const Attachment& attachment, const ToolPose& pose);

/// Share of a material point's weights at vertices that `fixed` lets move, for each axis, from 0 to 1.
Eigen::Vector3d free_share(const BodyModel& model, const Attachment& attachment);

}  // namespace thinwall
