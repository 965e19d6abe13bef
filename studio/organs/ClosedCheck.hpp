#pragma once

#include <string>

#include "engine/mesh/SurfaceMesh.hpp"
#include "studio/organs/SurfaceOrigin.hpp"

namespace thinwall {

/// Throws InputErrors unless wall and caps together are one closed oriented manifold, as a fluid inside needs. Says
/// which edges are open or shared by more than two triangles, in which vertices surfaces touch, and which components
/// there are, with the coordinates of the first few of each. `cure`: what helps against
/// open edges. `parts`: how many closed parts there may be.
void check_closed_for_fluid(const SurfaceMesh& mesh, const SurfaceOrigin& origin,
                            const std::string& cure = "close the surface", int parts = 1);

}  // namespace thinwall
