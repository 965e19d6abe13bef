#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// Checks recorded points and expectations: names of what exists, filled in where there is one only; bounds of the
/// quantity's dimension; times that the quantity takes.
void expectation_pass(CheckedValue& root, Diagnostics& diagnostics);

}  // namespace thinwall
