#pragma once

#include <functional>

#include "studio/organs/remeshing/FeatureLines.hpp"
#include "studio/organs/remeshing/TriangleSurface.hpp"

namespace thinwall {

/// What a mesh follows. Both get a point near the surface, metres, and the mesh's normal there (unit).
struct SurfaceToFollow {
  /// The point of the surface to take instead.
  std::function<Eigen::Vector3d(const Eigen::Vector3d& point, const Eigen::Vector3d& normal)> project;
  /// The surface's normal there (unit).
  std::function<Eigen::Vector3d(const Eigen::Vector3d& point, const Eigen::Vector3d& normal)> normal;
};

struct RemeshingOptions {
  int triangles = 5000;    // wanted; an even number is met exactly on a closed surface
  double edge_length = 0;  // metres; above zero it is the wanted length, and the number of triangles is what follows
  /// How long edges are at a point compared with elsewhere.
  std::function<double(const Eigen::Vector3d&)> relative_edge_length = [](const Eigen::Vector3d&) { return 1.0; };
  /// Lines of the start mesh that stay where they are. Borders must be among them.
  FeatureLines features = {};
};

/// Meshes a surface with nearly equilateral triangles, starting from any oriented manifold mesh of it: edges too long
/// are split, edges too short collapsed, edges turned so that vertices have six neighbours and small angles grow,
/// vertices moved along the surface to the middle of their triangles, again and again. Vertices on feature lines stay
/// on them, their corners in place. After Botsch and Kobbelt, A remeshing approach to multiresolution modeling, 2004.
TriangleSurface remesh(const TriangleSurface& start, const SurfaceToFollow& target, const RemeshingOptions& options);

}  // namespace thinwall
