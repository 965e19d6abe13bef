#pragma once

#include "engine/cutting/CutPatch.hpp"

namespace thinwall {

/// Makes the changed triangles of a patch wider without changing the surface: flips edges within flat pieces, moves
/// vertices that are free to, and puts vertices into flat pieces where nothing else helps. Ends when all angles reach
/// `enough`, radians, or nothing helps; where the angles allowed are missed more is tried. Triangles within reach but not
/// changed are only touched where that helps a changed one.
void improve(CutPatch& patch, double enough);

}  // namespace thinwall
