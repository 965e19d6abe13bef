#pragma once

#include "renderer/overlay/Overlay.hpp"
#include "renderer/overlay/Plate.hpp"

namespace thinwall {

/// The force against time up to now, lower right. `peak` (newton) is the largest force so far: it decides the axis.
void draw_force_plot(Image& image, const OverlayGrid& grid, const OverlayContent& content, double peak);

}  // namespace thinwall
