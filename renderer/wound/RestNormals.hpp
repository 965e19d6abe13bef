#pragma once

#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// (vertices), outward normals of the stress-free wall, of length one, weighted with the areas of the triangles around.
std::vector<Float3> rest_normals(const SnapshotTopology& topology);

}  // namespace thinwall
