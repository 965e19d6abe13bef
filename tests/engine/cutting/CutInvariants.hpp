#pragma once

#include <string>
#include <vector>

#include "engine/cutting/CutSurface.hpp"

namespace thinwall {

/// What a cut did wrong, as sentences; none if it kept every rule: topology, conservation, provenance, quality, books.
/// Checked from the meshes before and after alone, without the kernel's own maps.
std::vector<std::string> broken_rules(const SurfaceMesh& before, const CutSurface& after, const Cut& cut);

}  // namespace thinwall
