#pragma once

#include <vector>

#include "renderer/overlay/Box.hpp"

namespace thinwall {

/// The place nearest to `box` that is clear of all plates by `gap` and, where there is such a one, inside the bounds.
/// A way across counts three times, so that it goes above or below a plate rather than beside it. The box itself where
/// that is clear, or no place is. Lengths in pixels.
Box clear_place(const Box& box, const std::vector<Box>& plates, double gap, const Box& bounds);

}  // namespace thinwall
