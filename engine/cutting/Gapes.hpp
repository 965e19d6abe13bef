#pragma once

#include <vector>

#include "engine/cutting/CutSurface.hpp"

namespace thinwall {

/// What cuts have left open in a wall: loops of vertices along the lips, in the sense of the wall's triangles. Where
/// lips end at a border that was there before any cut, the loop goes straight over to the lip across, which begins in
/// the same place at rest: over the mouth of a notch, or on to the other part where a cut has come right through. The
/// outer border of a piece that was cut out is no gape; that of the hole is.
std::vector<std::vector<int>> gapes_of(const CutSurface& surface);

}  // namespace thinwall
