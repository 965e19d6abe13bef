#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// Checks that what is named exists: tools and bodies of clips, bodies of looks, mesh files, groups of
/// shapes. Fills in the tool or body
/// that a clip leaves out when there is one only. Errors with the nearest name; warns of tools that no clip uses.
void reference_pass(CheckedValue& root, Diagnostics& diagnostics);

}  // namespace thinwall
