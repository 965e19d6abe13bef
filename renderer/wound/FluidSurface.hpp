#pragma once

#include <span>
#include <vector>

#include "renderer/wound/FluidLevel.hpp"
#include "renderer/wound/WallHole.hpp"

namespace thinwall {

struct FluidVertex {
  Float3 position{};  // metres
  Float3 normal{};    // of length one, out of the fluid
};

/// What is seen of the fluid in an opened body.
struct FluidSurface {
  std::vector<FluidVertex> lid;    // (3 x triangles): where it stands in holes, below its level
  std::vector<FluidVertex> level;  // (3 x triangles), a fan: what an odd number of them covers is its level
};

/// The fluid of a body, which is the part of its cavity below a level; the cavity ends at lids over its holes, which
/// lie within the thickness of the wall. Empty for bodies that are closed, hold no fluid, or do not tell how much
/// they hold. `normals`: (vertices), outward; `thickness`: (vertices), metres, of the wall as it is drawn.
FluidSurface fluid_surface(const Snapshot& snapshot, const SnapshotSurface& surface, std::span<const WallHole> holes,
                           std::span<const Vector3> normals, std::span<const double> thickness);

}  // namespace thinwall
