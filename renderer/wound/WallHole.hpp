#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/snapshot/BorderEdges.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// A hole in a wall: a border that runs back into itself.
struct WallHole {
  std::vector<std::uint32_t> loop;  // vertices in the sense of the border
  std::vector<Triangle> lid;        // (loop - 2) triangles that close the hole, facing as the wall does
};

/// All holes of a surface, in the order of their first border edges. The lid is a strip between both sides of the loop,
/// from the vertex farthest from its middle on, so that it lies between the lips of a slit however the slit is bent.
std::vector<WallHole> find_wall_holes(std::span<const Float3> positions, std::span<const BorderEdge> borders);

/// Where a fluid that fills a body to the brim stands in a hole.
struct HoleMouth {
  std::vector<Triangle> lid;
  Vector3 outward;  // of length one, the mean of the lid's normals
};

/// The lid as it is without the flaps at its border: vertices that lie farther off the hole's plane, in or out, than
/// three tenths of its radius.
HoleMouth mouth_of(const WallHole& hole, std::span<const Float3> positions);

}  // namespace thinwall
