#include "engine/tool/ToolSolids.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace thinwall {
namespace {

constexpr double kPlateRounding = 1e-4;   // metres
constexpr double kJawRounding = 0.25;     // of the smallest of its sizes
constexpr double kNeedleTipRadius = 0.4;  // of the radius
constexpr double kNeedleCone = 4;         // times the radius, at most all but the balls at both ends

/// A box of full sizes along x', y', z' with rounded edges, whose foremost face has its middle at the tip.
ToolSolid box_behind(const ToolPose& pose, const Eigen::Vector3d& size, double rounding) {
  ToolSolid solid;
  solid.frame << pose.axis.cross(pose.direction), pose.axis, pose.direction;
  solid.radius = std::min(rounding, 0.5 * size.minCoeff());
  solid.core = (0.5 * size.array() - solid.radius).cwiseMax(0);
  solid.center = pose.tip - 0.5 * size.z() * pose.direction;
  return solid;
}

ToolSolid needle(const ToolDefinition& tool, const ToolPose& pose) {
  ToolSolid solid = box_behind(pose, {2 * tool.radius, 2 * tool.radius, tool.length}, tool.radius);
  solid.form = ToolSolid::Form::kNeedle;
  solid.tip_radius = kNeedleTipRadius * tool.radius;
  // From the ball at the tip to that at the back end, which has the radius of the shaft.
  const double front = tool.length - solid.tip_radius, back = tool.radius;
  solid.core = {0, 0, 0.5 * (front - back)};
  solid.center = pose.tip - (tool.length - 0.5 * (front + back)) * pose.direction;
  solid.shoulder = solid.core.z() - needle_cone(tool);
  return solid;
}

}  // namespace

double needle_cone(const ToolDefinition& tool) {
  return std::min(kNeedleCone * tool.radius, tool.length - (1 + kNeedleTipRadius) * tool.radius);
}

std::vector<ToolSolid> tool_solids(const ToolDefinition& tool, const ToolPose& pose) {
  switch (tool.kind) {
    case ToolKind::kPoint:
    case ToolKind::kLine:
      return {};
    case ToolKind::kSphere:
      return {box_behind(pose, Eigen::Vector3d::Constant(2 * tool.radius), tool.radius)};
    case ToolKind::kCapsule:
      return {
          box_behind(pose, {2 * tool.radius, std::max(tool.length, 2 * tool.radius), 2 * tool.radius}, tool.radius)};
    case ToolKind::kPlate: {
      const Eigen::Vector3d size(tool.width, tool.length, tool.thickness);
      return {box_behind(pose, size, std::min(kPlateRounding, 0.25 * size.minCoeff()))};
    }
    case ToolKind::kNeedle:
      return {needle(tool, pose)};
    case ToolKind::kScalpel:
      return {box_behind(pose, {tool.thickness, tool.width, tool.length}, 0.5 * tool.thickness)};
    case ToolKind::kForceps:
      break;
  }
  std::vector<ToolSolid> jaws;
  const Eigen::Vector3d size(tool.thickness, tool.width, tool.length);
  const Eigen::Vector3d across = pose.axis.cross(pose.direction);
  for (const double side : {1.0, -1.0}) {
    ToolPose jaw = pose;
    jaw.tip += side * 0.5 * (pose.opening + tool.thickness) * across;
    jaws.push_back(box_behind(jaw, size, kJawRounding * size.minCoeff()));
  }
  return jaws;
}

std::vector<ToolSolid> contact_solids(const ToolDefinition& tool, const ToolPose& pose) {
  std::vector<ToolSolid> solids;
  for (ToolSolid& solid : tool_solids(tool, pose)) {
    const std::vector<ToolSolid> corners = corners_of(solid);
    const std::vector<ToolSolid> rims = rims_of(solid);
    if (!corners.empty()) solid.role = rims.empty() ? ToolSolid::Role::kBody : ToolSolid::Role::kHull;
    solids.push_back(solid);
    solids.insert(solids.end(), rims.begin(), rims.end());
    solids.insert(solids.end(), corners.begin(), corners.end());
  }
  return solids;
}

std::vector<ToolSolid> contact_solids(std::span<const ToolDefinition> tools, std::span<const ToolPose> poses) {
  std::vector<ToolSolid> solids;
  for (std::size_t tool = 0; tool < tools.size(); ++tool) {
    for (const ToolSolid& solid : contact_solids(tools[tool], poses[tool])) solids.push_back(solid);
  }
  return solids;
}

}  // namespace thinwall
