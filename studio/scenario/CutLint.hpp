#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// Tells clips that cut or pierce with a tool of another kind or a wall without toughness, needles and blades that are
/// too short for their depth, ones that are moved and never cut or pierce, and a discharge of contents that do not
/// leak.
void check_cuts(const CheckedValue& root, Diagnostics& diagnostics);

}  // namespace thinwall
