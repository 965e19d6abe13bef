#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// Checks the names that the teaching layer uses, fills in the only body or tool where none is named, and checks that
/// spans end after they begin and slow motions do not overlap.
void teaching_references(CheckedValue& root, Diagnostics& diagnostics);

}  // namespace thinwall
