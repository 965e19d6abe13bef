#pragma once

#include <span>
#include <vector>

#include "engine/contact/ToolSolid.hpp"
#include "engine/tool/Tool.hpp"

namespace thinwall {

/// What a tool touches with at a pose: nothing for a point or a line, two jaws for forceps (that on the side of +x'
/// first), one solid otherwise. The tip of the pose is
/// - the foremost point of a sphere, of the middle of a capsule (along y', `length` over all) and of a needle,
/// - the middle of the foremost face of a plate, `width` by `length` and `thickness` thick behind it,
/// - the middle of the edge of a scalpel's blade: `width` along y', `length` backwards, rounded by half its thickness,
/// - the middle between the tips of the jaws: `width` along y', `length` backwards, `opening` apart along x'.
/// Edges of a plate are rounded by 0.1 mm, or a quarter of its smallest size where that is less; those of a jaw by a
/// quarter of its smallest size. A needle ends in a cone of four times its radius, rounded at the tip by 0.4 of the
/// radius.
std::vector<ToolSolid> tool_solids(const ToolDefinition& tool, const ToolPose& pose);

/// Length of the cone of a needle's point, metres.
double needle_cone(const ToolDefinition& tool);

/// The same solids as a wall feels them: each body followed by its corners, which keep out of the faces. A straight
/// edge or a flat side of a tool may rest on a face with two corners or more, where one deepest point of the whole
/// solid would jump from one to the other.
std::vector<ToolSolid> contact_solids(const ToolDefinition& tool, const ToolPose& pose);

/// Those of all tools at their poses, one after the other.
std::vector<ToolSolid> contact_solids(std::span<const ToolDefinition> tools, std::span<const ToolPose> poses);

}  // namespace thinwall
