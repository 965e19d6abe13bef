#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/shape/Outline.hpp"
#include "renderer/shape/ScreenArea.hpp"
#include "renderer/shape/SurfaceVertices.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// The triangles of a wall: (3 x triangles), counter-clockwise from outside, and the smallest box around them.
struct MeetingWall {
  std::span<const std::uint32_t> corners;
  Bounds bounds;
};

/// Adds the lines along which triangles of two walls go through each other, where both face `eye`: there one wall ends
/// and the other begins in a picture, though neither has an edge. The corners are those of `vertices`. Triangles that
/// lie in one plane have none.
void append_meeting_lines(std::span<const SurfaceVertex> vertices, const MeetingWall& first, const MeetingWall& second,
                          Vector3 eye, std::vector<OutlineSegment>& lines);

}  // namespace thinwall
