#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// Checks what no single value shows: a fluid in an open shape, a hole larger than its disc, a box turned inside out, a
/// camera that looks nowhere, a tool axis along its direction, two goldens or two clips of one tool at one time, a
/// golden after the end. Times of clips are compared as far as they are known before the simulation.
void lint_pass(const CheckedValue& root, Diagnostics& diagnostics);

}  // namespace thinwall
