#pragma once

#include <vector>

#include "studio/organs/MeshRepair.hpp"

namespace thinwall {

/// The numbers of the components (see `components_of`) that lie within another one that is closed, ascending. Parts
/// that pass through each other count by their first vertices.
std::vector<int> nested_parts(const RawSurface& surface);

}  // namespace thinwall
