#pragma once

#include <span>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// (vertices), of length one: the mean of the normals of the triangles around, weighted with their angles there, which
/// makes it independent of how the surface is cut into triangles (Thürmer and Wüthrich 1998).
std::vector<Vector3> vertex_normals(std::span<const Float3> positions, std::span<const Triangle> triangles);

}  // namespace thinwall
