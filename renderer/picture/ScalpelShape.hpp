#pragma once

#include "renderer/picture/ToolShape.hpp"

namespace thinwall {

/// A blade with a curved edge, ground on both sides, that is slipped over the tang of a flat handle. Its edge goes
/// through the tip, straight along y' and then up to the side of +y', towards which a blade cuts; none of it stands out
/// of what the engine presses with: `width`, `length`, `thickness`.
ToolShape scalpel_shape(const SnapshotTool& tool, double scene_size, BladeEdge edge);

}  // namespace thinwall
