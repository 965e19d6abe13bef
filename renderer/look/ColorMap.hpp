#pragma once

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// sRGB, 0 to 1, of a number from 0 to 1 (clamped): viridis (van der Walt and Smith 2015), whose lightness grows evenly
/// and which colour-blind people can read, by the polynomials of the sixth degree that Zucker fitted to it (2019).
Double3 color_map(double value);

}  // namespace thinwall
