#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

#include "engine/mesh/SurfaceMesh.hpp"

namespace thinwall {

struct GroupRegion {
  std::string name;
};
struct PlaneRegion {
  int axis = 2;          // 0, 1, 2 for x, y, z
  double at = 0;         // metres
  double within = 1e-6;  // metres, to either side
};
struct BelowRegion {
  int axis = 2;
  double at = 0;  // metres
};
struct AboveRegion {
  int axis = 2;
  double at = 0;  // metres
};
struct BoxRegion {
  Eigen::Vector3d min = Eigen::Vector3d::Zero();  // metres
  Eigen::Vector3d max = Eigen::Vector3d::Zero();  // metres
};
struct SphereRegion {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  // metres
  double radius = 0;                                 // metres
};
/// The open edges of the wall: those that bound one wall triangle only, capped or not.
struct BoundaryRegion {};
/// All of the wall.
struct WholeRegion {};

using Region = std::variant<GroupRegion, PlaneRegion, BelowRegion, AboveRegion, BoxRegion, SphereRegion, BoundaryRegion,
                            WholeRegion>;

/// Vertices of the stress-free mesh that lie in the region (limits included), ascending.
/// Throws std::out_of_range when a group region names a group that the mesh lacks.
std::vector<int> vertices_in(const Region& region, const SurfaceMesh& mesh);

/// Wall triangles whose centroid lies in the region; for groups and the boundary: whose three vertices do. Ascending.
/// Throws as `vertices_in`.
std::vector<int> triangles_in(const Region& region, const SurfaceMesh& mesh);

}  // namespace thinwall
