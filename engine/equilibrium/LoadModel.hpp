#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "engine/body/BodyDefinition.hpp"
#include "engine/shell/BendingElement.hpp"

namespace thinwall {

/// A share of a moment: it turns the line from the middle of an edge to the opposite corner of its triangle.
struct MomentLever {
  int triangle = 0;                                   // index
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  // of the triangle's corners: their sum makes the lever
  double moment = 0;                                  // newton metre
  int edge = 0;                                       // index, of the topology of the wall
  double turn = 0;                                    // 1 / metre: of a shell's free side, by the turn of the edge
};

/// A load with everything that does not change with the shape.
struct LoadModel {
  LoadKind kind = LoadKind::kDeadForce;
  Eigen::VectorXd force;                            // (3 vertices), newton: dead loads; empty for others
  double pressure = 0;                              // pascal
  std::vector<int> triangles;                       // that the pressure acts on
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // of the moment, unit
  std::vector<MomentLever> levers;
};

/// `area`: (triangles), metres^2, rest; `thickness`: (triangles), metres. Throws std::invalid_argument when the region
/// holds nothing that the load could act on, and std::out_of_range when it names a group that the mesh lacks.
LoadModel make_load_model(const LoadDefinition& load, const SurfaceMesh& mesh, const std::vector<double>& area,
                          const std::vector<double>& thickness);

/// Lets the moments on free sides of a shell turn the wall's normal there, which may have turned off the triangle's.
/// `bending`: (triangles), or none.
void add_turns(const SurfaceMesh& mesh, std::span<const BendingRest> bending, LoadModel& load);

}  // namespace thinwall
