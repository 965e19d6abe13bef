#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "engine/solver/Lanes.hpp"
#include "engine/wall/MembraneElement.hpp"

namespace thinwall {

/// A membrane triangle whose terms are wanted. What it points at outlives it.
struct MembraneTriangle {
  const MembraneRest* rest = nullptr;
  const Material* material = nullptr;
  std::array<Eigen::Vector3d, 3> corners;  // metres
  MembraneMemory memory;
};

/// A number of each of kLanes triangles.
using OfLanes = std::array<double, kLanes>;

/// Terms of kLanes triangles side by side, as of MembraneTerms: every number of all of them together.
struct MembraneLanes {
  OfLanes energy, strain_energy;                  // joule
  std::array<OfLanes, 9> gradient;                // newton
  OfLanes largest_force;                          // newton, of the gradient
  std::array<std::array<OfLanes, 9>, 6> hessian;  // newton / metre, the blocks of kBlockCorners by columns, of those on
                                                  // the diagonal the lower triangle
};

/// The terms of one to kLanes triangles; lanes beyond them repeat the last. What a triangle gets does not depend on the
/// others. With F = (f0, f1), shape gradients g_a and the tangent D in (E11, E22, 2 E12), the block (a, b) of the
/// Hessian is F m F^T + (g_a . S g_b) 1, where m is D contracted with g_a and g_b (Bonet and Wood 2008, section 9.4);
/// the blocks of the first corner follow from the others, as a triangle that moves as a whole bears no force. Without
/// `with_hessian` that is left as it was.
void membrane_lanes(std::span<const MembraneTriangle> triangles, bool with_hessian, MembraneLanes& terms);

}  // namespace thinwall
