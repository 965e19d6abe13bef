#pragma once

#include <string>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// Throws InputErrors where a camera of a scenario, as it stands before anything moves it or at one of its keyframes,
/// can look nowhere in what the first moment shows: without `target` in the middle of the bodies.
void refuse_blind_cameras(const Scenario& scenario, const Snapshot& first);

/// Of cameras that stand within a closed body then and are no endoscopes, as by a wrong unit: a sentence each.
std::vector<std::string> cameras_within_bodies(const Scenario& scenario, const Snapshot& first);

}  // namespace thinwall
