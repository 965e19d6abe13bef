#pragma once

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Newton, about as large as the force gets that a tool feels at the walls of a scene: that of soft tissue as thick as
/// the thickest wall and as large as the largest body, scenery aside. It is told by the bodies' stress-free shapes
/// alone, so it is known before anything touches and stays the same throughout a take.
double expected_force(const Snapshot& snapshot);

}  // namespace thinwall
