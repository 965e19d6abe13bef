#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// Checks the names that cameras and cuts use, fills in the only tool where a camera follows one without naming it, and
/// checks that times ascend and cameras do not stand at their targets.
void camera_references(CheckedValue& root, Diagnostics& diagnostics);

}  // namespace thinwall
