#pragma once

#include <Eigen/Core>
#include <string>

namespace thinwall {

enum class ToolKind { kPoint, kLine, kSphere };

struct ToolDefinition {
  std::string name;
  ToolKind kind = ToolKind::kPoint;
  double length = 0;  // metres, line
  double radius = 0;  // metres, sphere
};

/// Where a tool is. The frame is orthonormal: x' = axis x direction.
struct ToolPose {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();          // metres
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();  // z', the sense of motion into the body, unit
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();        // y', along a line tool, unit, perpendicular to z'
};

}  // namespace thinwall
