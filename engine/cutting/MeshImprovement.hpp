#pragma once

#include "engine/cutting/CutPatch.hpp"

namespace thinwall {

/// Makes the changed triangles of a patch wider without changing the surface: flips edges within flat pieces, moves
/// vertices that are free to, and puts vertices into flat pieces where nothing else helps. Ends when all angles are a
/// little larger than they must be, or nothing helps. Triangles that have not changed are only touched where that helps
/// one that has.
void improve(CutPatch& patch);

}  // namespace thinwall
