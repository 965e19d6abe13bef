#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

namespace thinwall {

/// The stress-free surface of a body: a triangulated wall, and caps that close the fluid without stiffness.
struct SurfaceMesh {
  std::vector<Eigen::Vector3d> vertices;           // (vertices x 3), metres
  std::vector<Eigen::Vector3i> triangles;          // (triangles x 3), wall; counter-clockwise seen from outside
  std::vector<Eigen::Vector3i> cap_triangles;      // (caps x 3), oriented like the wall, no vertices of their own
  std::map<std::string, std::vector<int>> groups;  // name -> vertex indices, ascending
};

}  // namespace thinwall
