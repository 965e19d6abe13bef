#pragma once

#include "renderer/shape/ToolShape.hpp"

namespace thinwall {

/// A blade with a curved edge, ground on both sides, that is slipped over the tang of a flat handle. Its point is the
/// tip: from there the edge goes up to the side of +y', towards which a blade cuts, and the back to the other; none of
/// it stands out of what the engine presses with: `width`, `length`, `thickness`.
ToolShape scalpel_shape(const SnapshotTool& tool, double scene_size, ToolDetail detail);

}  // namespace thinwall
