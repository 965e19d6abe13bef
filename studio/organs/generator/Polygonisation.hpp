#pragma once

#include <Eigen/Core>

#include "studio/organs/generator/ImplicitBody.hpp"
#include "studio/organs/remeshing/TriangleSurface.hpp"

namespace thinwall {

/// The surface of a body inside a box, by marching tetrahedra: six to each cube of a grid, all alike, so that the
/// result is a closed oriented manifold whatever the body. The body must lie inside the box. Its triangles are badly
/// shaped.
TriangleSurface polygonise(const ImplicitBody& body, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                           double step);

}  // namespace thinwall
