#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "engine/mesh/SurfaceMesh.hpp"
#include "studio/organs/generator/ImplicitBody.hpp"

namespace thinwall {

/// What the generator needs to know of an organ.
struct OrganPlan {
  ImplicitBody body;
  Eigen::Vector3d low = Eigen::Vector3d::Zero();   // metres, of a box that holds the body
  Eigen::Vector3d high = Eigen::Vector3d::Zero();  // metres
  double grid_step = 1.2e-3;                       // metres; a quarter of the width of the thinnest part, or less
  /// How long edges are at a point compared with elsewhere, so that thin parts get enough of them.
  std::function<double(const Eigen::Vector3d&)> relative_edge_length;
  /// The group of a triangle by its centre and outward normal: an anatomical part.
  std::function<std::string(const Eigen::Vector3d&, const Eigen::Vector3d&)> group_at;
};

/// An organ's mesh: each triangle is in one part.
struct OrganMesh {
  std::vector<Eigen::Vector3d> vertices;   // (vertices x 3), metres
  std::vector<Eigen::Vector3i> triangles;  // (triangles x 3), counter-clockwise seen from outside
  std::vector<std::string> groups;         // (triangles)
};

/// Meshes an organ with so many triangles (an even number).
OrganMesh mesh_organ(const OrganPlan& plan, int triangles);

/// A file that scripts/organs writes.
struct OrganFile {
  std::string name;  // in scenes/organs
  OrganPlan (*plan)();
  int triangles = 0;
};

/// All of them. A new organ is a function like plan_gallbladder and a row in this table.
const std::vector<OrganFile>& organ_files();

/// The file's text: Wavefront OBJ in millimetres, to the micrometre, a group of faces for each part.
std::string organ_text(const OrganFile& file);

}  // namespace thinwall
