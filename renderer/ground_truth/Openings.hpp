#pragma once

#include <vector>

#include "renderer/ground_truth/Projection.hpp"
#include "renderer/ground_truth/SceneGeometry.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// (height x width), 1 where the ray of a pixel's middle goes through an opening within a wall that cuts have made,
/// from lip to lip on its outer side. A cut that runs out of a wall at its border leaves no such opening.
std::vector<char> rays_through_openings(const Snapshot& snapshot, const SceneGeometry& geometry,
                                        const Projection& projection);

}  // namespace thinwall
