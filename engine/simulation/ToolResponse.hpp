#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "engine/tool/Tool.hpp"

namespace thinwall {

/// A small motion of a tool: of its tip along x, y, z, metres, and its turn about the tip around x, y, z, radians.
using ToolMotion = Eigen::Matrix<double, 6, 1>;

/// Motion of a tool from one pose to another: of its tip, and the turn of its frame.
ToolMotion motion_between(const ToolPose& from, const ToolPose& to);

/// A place where a tool presses on a wall, and how it answers a small motion of the tool.
struct SiteResponse {
  double force = 0;                                                                    // newton
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();                                    // unit, out of the tool
  Eigen::Matrix<double, 1, 6> force_by_motion = Eigen::Matrix<double, 1, 6>::Zero();   // newton / metre, newton
  Eigen::Matrix<double, 3, 6> normal_by_motion = Eigen::Matrix<double, 3, 6>::Zero();  // 1 / metre, a number
};

/// The wall ahead of a tool that does not touch it.
struct WallAhead {
  double gap = std::numeric_limits<double>::infinity();  // metres
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();      // unit, out of the tool
  double stiffness = 0;                                  // newton / metre, of the place that will be met first
};

/// What a body does to a tool in equilibrium, and how that changes with small motions of the tool, to first order: the
/// wall with all that it encloses gives way, and contacts that press keep pressing.
struct ToolResponse {
  ToolPose pose;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // newton, what the tissue does to the tool, friction included
  std::vector<SiteResponse> sites;
  bool holds = false;                                    // whether the tool prescribes displacements where it touches
  Eigen::Vector3d held_force = Eigen::Vector3d::Zero();  // newton, part of `force`
  Eigen::Matrix<double, 3, 6> held_by_motion = Eigen::Matrix<double, 3, 6>::Zero();  // newton / metre, newton
  WallAhead ahead;

  bool is_touching() const { return holds || !sites.empty(); }
};

}  // namespace thinwall
