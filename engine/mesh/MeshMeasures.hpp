#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "engine/mesh/SurfaceMesh.hpp"

namespace thinwall {

/// The box around points, metres; empty without any.
Eigen::AlignedBox3d bounding_box(std::span<const Eigen::Vector3d> points);

/// Area of each triangle, (triangles), metres^2.
std::vector<double> triangle_areas(std::span<const Eigen::Vector3d> vertices,
                                   std::span<const Eigen::Vector3i> triangles);

/// Area of the wall, caps left out, metres^2.
double wall_area(const SurfaceMesh& mesh);

/// Volume that an oriented closed surface encloses, metres^3: V = 1/6 sum xa . (xb x xc), by the divergence theorem.
/// Taken about the first vertex used, which loses no digits when the surface lies far from the origin.
double enclosed_volume(std::span<const Eigen::Vector3d> vertices, std::span<const Eigen::Vector3i> triangles);

/// Volume inside wall and caps, metres^3. Meaningful only when the two together are closed.
double enclosed_volume(const SurfaceMesh& mesh);

/// Solid angle of a triangle seen from a point, positive from behind, steradian (Van Oosterom and Strackee 1983). Over
/// a closed surface the sum is 4 pi for points inside.
double solid_angle(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& point);

/// Smallest angle of each triangle, (triangles), radians; 0 for a triangle without area.
std::vector<double> smallest_angles(std::span<const Eigen::Vector3d> vertices,
                                    std::span<const Eigen::Vector3i> triangles);

/// How well the wall is meshed.
struct MeshQuality {
  double least_angle = 0;    // radians, the smallest angle of all
  double median_angle = 0;   // radians, median of the triangles' smallest angles
  double largest_angle = 0;  // radians, the largest angle of all
  double least_area = 0;     // metres^2
  double mean_area = 0;      // metres^2
  double largest_area = 0;   // metres^2
};

/// Quality of a mesh's wall, caps left out. The wall must have triangles.
MeshQuality quality_of(const SurfaceMesh& mesh);

}  // namespace thinwall
