#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "studio/organs/remeshing/Remeshing.hpp"

namespace thinwall {

/// A field at a point: below zero inside a body, above outside, near the surface about the distance to it.
/// Fields use no arithmetic but + - * / and the square root, which are exact everywhere, so that organs come out the
/// same on every machine.
struct FieldValue {
  double value = 0;                                    // metres
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  // by metres
};

using ImplicitBody = std::function<FieldValue(const Eigen::Vector3d&)>;

ImplicitBody sphere_body(const Eigen::Vector3d& centre, double radius);

/// What lies on the far side of a plane: `normal` (unit) points out of the body.
ImplicitBody half_space_body(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

struct AxisPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // metres
  double radius = 0;                                   // metres
};

/// What a sphere sweeps whose centre and radius follow a uniform cubic B-spline of the given control points, which
/// starts at the first and ends at the last of them. The radius must change more slowly than the place.
ImplicitBody swept_sphere_body(const std::vector<AxisPoint>& control_points);

/// Union and intersection with a seam rounded over `blend` metres, twice differentiable: min(a, b) - blend h^3 / 6 with
/// h = max(1 - |a - b| / blend, 0).
ImplicitBody smooth_union(ImplicitBody a, ImplicitBody b, double blend);
ImplicitBody smooth_intersection(ImplicitBody a, ImplicitBody b, double blend);

/// What lies outside of a body.
ImplicitBody outside_of(ImplicitBody body);

/// A body made longer by a factor along each axis, about the origin; the values stay below the distance.
ImplicitBody stretched_body(ImplicitBody body, const Eigen::Vector3d& factors);

/// The point of the surface that steps along the gradient lead to.
Eigen::Vector3d project_to_surface(const ImplicitBody& body, Eigen::Vector3d point);

/// The body's surface, for a mesh to follow. The body must outlive it.
SurfaceToFollow surface_of(const ImplicitBody& body);

}  // namespace thinwall
