#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>

namespace thinwall {

enum class ToolKind { kPoint, kLine, kSphere, kCapsule, kPlate, kNeedle, kScalpel, kForceps };

/// Their names, in that order.
inline constexpr auto kToolKindNames =
    std::to_array<std::string_view>({"point", "line", "sphere", "capsule", "plate", "needle", "scalpel", "forceps"});

/// Point and line prescribe displacements; all others touch with solids, whose shapes ToolSolids.hpp describes.
struct ToolDefinition {
  std::string name;
  ToolKind kind = ToolKind::kPoint;
  double length = 0;     // metres; line, capsule, plate (along y'), needle, scalpel, forceps
  double radius = 0;     // metres; sphere, capsule, needle
  double width = 0;      // metres; plate (along x'), scalpel, forceps (along y')
  double thickness = 0;  // metres; plate, scalpel, each jaw of forceps
  double opening = 0;    // metres between the jaws of open forceps
  double deviation = 0;  // metres; scalpel: triangles are refined where its cut would be farther off its way; 0: never
  double friction = 0;   // coefficient of Coulomb's law; not of point and line
};

/// Where a tool is. The frame is orthonormal: x' = axis x direction.
struct ToolPose {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();          // metres
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();  // z', the sense of motion into the body, unit
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();        // y', along a line tool, unit, perpendicular to z'
  double opening = 0;                                     // metres between the jaws of forceps
};

}  // namespace thinwall
