#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// Tells tools that grasp without jaws or without friction, jaws that close wider than they open, and a release of what
/// no earlier clip has grasped.
void check_grasps(const CheckedValue& root, Diagnostics& diagnostics);

}  // namespace thinwall
