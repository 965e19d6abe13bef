#pragma once

#include <span>
#include <vector>

#include "engine/material/WallLaw.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "engine/mesh/SurfaceMesh.hpp"
#include "engine/shell/BendingElement.hpp"
#include "engine/wall/MembraneElement.hpp"

namespace thinwall {

/// The bending triangles of a wall; the edges are numbered as its topology does. `clamped`: (vertices), whether open
/// sides between two such vertices keep the plane that the wall has across them: what a clamp holds, or a plane of
/// symmetry. The lengths of the sides are those of each triangle's rest shape; the bending stiffness is thickness^3 /
/// 12 times the tangent of the unstrained law. `turn_length`: metres, that makes a length of a side's angle, so that
/// all unknowns are alike. `rest`, `materials`: (triangles); a single material stands for all.
std::vector<BendingRest> make_bending_rests(const SurfaceMesh& mesh, const MeshEdges& edges,
                                            std::span<const MembraneRest> rest, std::span<const Material> materials,
                                            const std::vector<char>& clamped, double turn_length);

/// The part of the unknowns that a triangle's bending depends on. `unknowns`: (3 vertices + edges), metres.
BendingPatch patch_of(const BendingRest& rest, const Eigen::VectorXd& unknowns, int vertices);

/// Their indices, in the order of the derivatives. What is missing at a border repeats the first.
std::array<int, 21> unknowns_of(const BendingRest& rest, int vertices);

}  // namespace thinwall
