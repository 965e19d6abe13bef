#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// A clip of the timeline from a checked value that the schema let through. `item`: of the list.
Clip to_clip(const CheckedValue& item);

}  // namespace thinwall
