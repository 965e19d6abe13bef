#pragma once

#include <functional>

#include "studio/organs/generator/Polygonisation.hpp"

namespace thinwall {

struct RemeshingOptions {
  int triangles = 5000;  // wanted; an even number is met exactly
  /// How long edges are at a point compared with elsewhere.
  std::function<double(const Eigen::Vector3d&)> relative_edge_length = [](const Eigen::Vector3d&) { return 1.0; };
};

/// Meshes the surface of a body with nearly equilateral triangles, starting from any closed mesh of it: edges too long
/// are split, edges too short collapsed, edges turned so that vertices have six neighbours and small angles grow,
/// vertices moved along the surface to the middle of their triangles, again and again. After Botsch and Kobbelt, A
/// remeshing approach to multiresolution modeling, 2004.
TriangleSurface remesh(const TriangleSurface& start, const ImplicitBody& body, const RemeshingOptions& options);

}  // namespace thinwall
