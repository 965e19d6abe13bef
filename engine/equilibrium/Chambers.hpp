#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/body/BodyDefinition.hpp"

namespace thinwall {

/// A closed part of the surface with the fluid in it.
struct ChamberModel {
  std::string name;                                 // empty when the definition names none
  double rest_volume = 0;                           // metres^3
  Eigen::Vector3d level = Eigen::Vector3d::Zero();  // metres, centroid at rest: where the pressure is told
  std::optional<double> initial_pressure;           // pascal
  // Metres^3 between the caps that span the lips of an opening and the surface of contents that do not run out, which
  // is where it was when the cut changed the lips.
  double beyond_caps = 0;
};

struct Chambers {
  std::vector<ChamberModel> chambers;  // in the order of the definition, then the others by their first triangle
  std::vector<int> of_triangle;        // (triangles), index; -1 of parts that hold nothing
};

/// The parts of a closed surface that hang together. Throws std::invalid_argument when the point that names a chamber
/// lies in none, or in one that has a name already.
Chambers find_chambers(std::span<const Eigen::Vector3d> vertices, std::span<const Eigen::Vector3i> triangles,
                       const FluidDefinition& fluid);

}  // namespace thinwall
