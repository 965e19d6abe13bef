#pragma once

#include <span>
#include <vector>

#include "engine/material/WallLaw.hpp"
#include "engine/mesh/SurfaceMesh.hpp"
#include "engine/shell/BendingElement.hpp"
#include "engine/wall/MembraneElement.hpp"

namespace thinwall {

/// The bending patches of a wall. `clamped`: (vertices), whether open sides between two such vertices keep their
/// tangent plane. The neighbours are unfolded into the plane of each triangle and shrunk with its prestretch; the
/// bending stiffness is thickness^3 / 12 times the tangent of the unstrained law.
/// `rest`, `materials`: (triangles); a single material stands for all.
std::vector<BendingRest> make_bending_rests(const SurfaceMesh& mesh, std::span<const MembraneRest> rest,
                                            std::span<const Material> materials, const std::vector<char>& clamped);

/// Positions of the vertices of a patch. `position`: (3 vertices), metres.
BendingPatch patch_of(const BendingRest& rest, const Eigen::VectorXd& position);

}  // namespace thinwall
