#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// Tells of steps in which a tool that presses or pierces goes all its depth and farther, so that nothing of how it
/// gets there is seen, and of steps that are long for a dynamic analysis.
void check_steps(const CheckedValue& root, Diagnostics& diagnostics);

}  // namespace thinwall
