#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/body/BodyDefinition.hpp"

namespace thinwall {

/// What closes the fluid where the wall does not: triangles, and how much of each counts.
struct CapSurface {
  std::vector<Eigen::Vector3i> triangles;
  std::vector<double> share;  // (triangles)
  std::vector<int> cap;       // (triangles), the cap triangle of the mesh that each stands for
};

/// The caps of a mesh as the pressure meets them. A flat cap that is held along its normal is as the mesh has it. Of
/// one whose rim can leave its plane no triangles between the vertices of its rim would do: they pull at some vertices
/// and hardly at others, which a membrane answers with teeth that grow as its triangles get finer. It is the cone from
/// the rim's mean point, by length at rest: every stretch of the rim bears its part, and the cap encloses the same when
/// a cut divides an edge of its rim. As volume is linear in each vertex that is the mean of the fans from all vertices
/// of the rim, with what each is in the mean point.
CapSurface spread_caps(const SurfaceMesh& mesh, std::span<const FixedRegion> fixed);

/// Whether caps meet at an angle along an edge whose ends are not held along the normals of both, as those of a
/// semicylinder: with no wall there its two ends bear what presses on the caps along it, which no membrane can.
bool has_free_corner(const SurfaceMesh& mesh, std::span<const FixedRegion> fixed);

}  // namespace thinwall
