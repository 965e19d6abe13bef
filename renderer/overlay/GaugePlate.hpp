#pragma once

#include "renderer/overlay/Overlay.hpp"
#include "renderer/overlay/Plate.hpp"

namespace thinwall {

/// Tool, phase, force, depth and pressure as numbers, lower left. `peak` (newton) is the largest force so far: it
/// decides the decimals.
void draw_gauge(Image& image, const OverlayGrid& grid, const OverlayContent& content, double peak);

}  // namespace thinwall
