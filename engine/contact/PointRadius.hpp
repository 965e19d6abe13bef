#pragma once

#include <Eigen/Core>
#include <span>

namespace thinwall {

/// Radius of the tip, metres, that a bare point on a membrane acts like: the force on a drum of tension T and radius a,
/// F = 2 pi T depth / ln(a / radius), falls with every refinement, because a membrane gives way to a point without end.
/// At a vertex of equilateral triangles it is edge exp(-gamma) / sqrt(12) = 0.162 edge (gamma Euler's constant), from
/// the resistance between distant nodes of a triangular lattice (Atkinson and van Steenwijk 1999); a point of
/// barycentric weights w within a triangle spreads its force, which multiplies it by exp(2 pi / sqrt(3) (w0 w1 + w1 w2
/// + w2 w0)), up to 3.35. On other triangles the mean edge stands for the edge. `position`: (3 vertices), metres, of
/// the wall as it is.
double effective_point_radius(std::span<const Eigen::Vector3i> triangles, const Eigen::VectorXd& position,
                              const Eigen::Vector3i& vertices, const Eigen::Vector3d& weights);

}  // namespace thinwall
