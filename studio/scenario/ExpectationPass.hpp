#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// Checks recorded points and expectations: names of what exists, filled in where there is one only; bounds of the
/// quantity's dimension; times that the quantity takes. A tolerance that is a part of the value becomes one in its
/// unit.
void expectation_pass(CheckedValue& root, Diagnostics& diagnostics);

}  // namespace thinwall
