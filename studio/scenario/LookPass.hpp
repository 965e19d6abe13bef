#pragma once

#include "studio/scenario/CheckedValue.hpp"

namespace thinwall {

/// Gives each body a look with an `organ`: where the scenario does not say one, the one whose name is part of the
/// body's name or of its mesh file's, otherwise any tissue. Gives an endoscope its lamp.
void look_pass(CheckedValue& root);

}  // namespace thinwall
