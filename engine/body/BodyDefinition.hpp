#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/material/WallLaw.hpp"
#include "engine/mesh/Region.hpp"
#include "engine/mesh/SurfaceMesh.hpp"

namespace thinwall {

enum class FluidKind { kNone, kIncompressible, kCompressible };

/// The fluid that the wall and the caps enclose.
struct FluidDefinition {
  FluidKind kind = FluidKind::kIncompressible;
  // Pascal above the surroundings, at time zero: the volume follows. Absent: the volume is the mesh's and the pressure
  // follows.
  std::optional<double> initial_pressure;
  double density = 1010;      // kg / metre^3
  double bulk_modulus = 2e6;  // pascal, compressible only
};

/// Vertices that keep their stress-free positions along some axes.
struct FixedRegion {
  Region region;
  std::array<bool, 3> axes = {true, true, true};  // x, y, z
};

/// Everything about a body that does not change while it is simulated.
struct BodyDefinition {
  std::string name;
  SurfaceMesh mesh;
  std::vector<double> thickness;  // (triangles), metres, of the stress-free wall
  double density = 1060;          // kg / metre^3, of the wall
  Material material;
  double prestretch = 1;  // each triangle's rest shape is the given one shrunk by this
  FluidDefinition fluid;
  std::vector<FixedRegion> fixed;
};

}  // namespace thinwall
